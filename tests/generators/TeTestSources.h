#pragma once

#include "generators/TeHeightSource.h"
#include "generators/base/TeRandom.h"

#include <utility>

/// Every map of this source is a copy of one given map, whose size alone it accepts.
class TeGivenMap final : public TePointSource {
public:
  explicit TeGivenMap(TeHeightMap map) : m_map(std::move(map)) {}
  std::string name() const override { return "given"; }
  std::uint64_t fingerprint() const override { return 1; }
  TeStatus accepts(int columns, int rows) const override {
    if (columns == m_map.width() && rows == m_map.height())
      return {};
    return TeError{"given: another size"};
  }
  TeStatus evaluate(const TeMapRequest&, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    for (std::size_t i = 0; i < count; ++i)
      heights[i] = m_map.at(samples[i].column, samples[i].row);
    return {};
  }

private:
  TeHeightMap m_map;
};

inline TeHeightMap teRandomMap(int width, int height, std::uint64_t seed, double size = 100.0) {
  TeHeightMap map = TeHeightMap::create(width, height).value();
  TeRandom random(seed, 77, {width, height});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.at(x, y) = float(random.uniform(-size, size));
  return map;
}

/// Makes about one sample in `oneIn` missing.
inline void tePunchHoles(TeHeightMap& map, std::uint64_t seed, std::uint64_t oneIn) {
  TeRandom random(seed, 78, {});
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      if (random.below(oneIn) == 0)
        map.at(x, y) = TeHeightMap::missing();
}
