#include "nodes/TeSurfaceColours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
const glm::vec3 kUp(0, 0, 1);
const glm::vec3 kSteep(0.9f, 0, std::sqrt(1 - 0.81f));
} // namespace

TEST(TeSurfaceColours, GrassRockSnowByHeight) {
  const TeSurfaceColours colours = TeSurfaceColours::forHeights(500, 1000);
  EXPECT_EQ(colours.colour(100, kUp), colours.grass);
  EXPECT_EQ(colours.colour(690, kUp), colours.rock);
  EXPECT_EQ(colours.colour(950, kUp), colours.snow);
}

TEST(TeSurfaceColours, SteepGroundIsRockAtAnyHeight) {
  const TeSurfaceColours colours = TeSurfaceColours::forHeights(500, 1000);
  for (float height : {0.0f, 500.0f, 1000.0f})
    EXPECT_EQ(colours.colour(height, kSteep), colours.rock);
}

TEST(TeSurfaceColours, ChangesWithoutSteps) {
  const TeSurfaceColours colours = TeSurfaceColours::forHeights(500, 1000);
  glm::vec3 before = colours.colour(0, kUp);
  for (int h = 1; h <= 1000; h++) {
    const glm::vec3 now = colours.colour(float(h), kUp);
    for (int channel = 0; channel < 3; channel++)
      EXPECT_LE(std::abs(now[channel] - before[channel]), 0.01f) << h;
    before = now;
  }
}

TEST(TeSurfaceColours, FlatOrHugeRangesGiveColours) {
  for (const TeSurfaceColours& colours :
       {TeSurfaceColours::forHeights(5, 5), TeSurfaceColours::forHeights(-1e30f, 1e30f)}) {
    for (float height : {-1e30f, 0.0f, 5.0f, 1e30f}) {
      const glm::vec3 colour = colours.colour(height, kUp);
      for (int channel = 0; channel < 3; channel++) {
        EXPECT_GE(colour[channel], 0);
        EXPECT_LE(colour[channel], 1);
      }
    }
  }
}

TEST(TeSurfaceColours, PackedIsTheNearestByteOfEachChannel) {
  TeSurfaceColours colours;
  colours.grass = {0.2f, 1.5f, -1};
  colours.rockLine = 1000;
  colours.snowLine = 2000;
  EXPECT_EQ(colours.packed(0, kUp), 0x33FF00FFu);
}
