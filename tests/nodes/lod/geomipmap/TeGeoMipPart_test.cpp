#include "nodes/lod/geomipmap/TeGeoMipPart.h"

#include <gtest/gtest.h>

#include <random>

TEST(TeGeoMipPart, comesBackFromItsKey) {
  std::mt19937 random(1);
  const auto upTo = [&](std::uint32_t most) { return int(random() % (most + 1)); };
  for (const int patches : {1, 128, 4096})
    for (int trial = 0; trial < 500; trial++) {
      TeGeoMipPart part;
      part.x = upTo(std::uint32_t(patches) - 1);
      part.y = upTo(std::uint32_t(patches) - 1);
      part.level = upTo(7);
      part.weight = upTo(TeGeoMipPart::kWhole);
      for (std::size_t side = 0; side < 4; side++) {
        part.sides[side] = upTo(7);
        part.borderWeights[side] = upTo(TeGeoMipPart::kWhole);
      }
      const TeGeoMipPart back = TeGeoMipPart::of(part.key(patches), patches);
      EXPECT_EQ(back.x, part.x);
      EXPECT_EQ(back.y, part.y);
      EXPECT_EQ(back.level, part.level);
      EXPECT_EQ(back.sides, part.sides);
      EXPECT_EQ(back.weight, part.weight);
      EXPECT_EQ(back.borderWeights, part.borderWeights);
    }
}
