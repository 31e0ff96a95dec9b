#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

// Float noise libraries give 33 distinct heights in 1024 neighbouring samples a million units out.
TEST(HardCase, FarFromOriginNoise) {
  for (TeNoiseType type : {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp}) {
    TeNoiseSettings settings;
    settings.type = type;
    const TeHeightSourcePtr source = *TeNoiseSource::create(settings);
    std::size_t atOrigin = 0;
    for (double distance : {0.0, 1e6, 1e7, 1e12, 0x1p59}) {
      TeMapRequest request = *TeMapRequest::standalone(1024, 1, 1.0, 1);
      request.firstX = std::int64_t(distance);
      request.firstY = -std::int64_t(distance);
      const TeHeightMap map = *source->generate(request);
      const std::set<float> heights(map.row(0), map.row(0) + 1024);
      std::printf("noise type %d, %.4g units out: %zu distinct heights in 1024 samples\n", int(type),
                  distance, heights.size());
      if (distance == 0)
        atOrigin = heights.size();
      EXPECT_GE(heights.size(), 1020u);
      EXPECT_GE(heights.size() + 4, atOrigin);
    }
  }
}
