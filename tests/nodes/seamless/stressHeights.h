#pragma once

#include "generators/TeHeightMap.h"
#include "generators/base/TeRandom.h"

#include <cmath>
#include <string>
#include <vector>

/// Terrains that are hard on error bounds; whole numbers 0 .. 65535 but for "fractions".
inline const std::vector<std::string>& stressKinds() {
  static const std::vector<std::string> kinds = {"random",  "fractions",    "spike", "cliff",
                                                 "plateau", "checkerboard", "flat",  "hills"};
  return kinds;
}

inline TeHeightMap stressHeights(const std::string& kind, int resolution) {
  TeHeightMap map = std::move(TeHeightMap::create(resolution + 1, resolution + 1).value());
  TeRandom random(4, 0, TeMapKey{});
  const int spikeX = resolution / 3, spikeY = resolution / 5;
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++) {
      float& height = map.at(x, y);
      if (kind == "random")
        height = float(random.below(65536));
      else if (kind == "fractions")
        height = float(random.uniform(-1000, 1000));
      else if (kind == "spike")
        height = x == spikeX && y == spikeY ? 65535 : 0;
      else if (kind == "cliff")
        height = 3 * x + 5 * y > 4 * resolution ? 40000 : 20;
      else if (kind == "plateau")
        height = x > resolution / 4 && x < resolution * 5 / 8 && y > resolution / 3 ? 30000 : 1000;
      else if (kind == "checkerboard")
        height = (x + y) % 2 ? 65535 : 0;
      else if (kind == "flat")
        height = 1234;
      else
        height = std::round(float(20000 + 9000 * std::sin(x * 0.11) * std::cos(y * 0.07 + 1)));
    }
  return map;
}
