#include "nodes/lod/quadtree/TeQuadtreeSquare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

TEST(TeQuadtreeSquare, IsNoLargerThanTheDocuments) { EXPECT_LE(sizeof(TeQuadtreeSquare), 36u); }

TEST(TeQuadtreeSquare, ErrorsAreRoundedUpAndHardlyLarger) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int i = 0; i < 100000; i++) {
    const double number = std::exp(exponent(random));
    const double packed = double(teUnpack(tePackUp(number)));
    ASSERT_GE(packed, number);
    ASSERT_LE(packed, number * (1 + 1.0 / 256));
    ASSERT_EQ(tePackUp(packed), tePackUp(number)); // what fits is kept
  }
  EXPECT_EQ(teUnpack(tePackUp(0)), 0);
  EXPECT_EQ(teUnpack(tePackUp(5)), 5);
  EXPECT_GT(teUnpack(tePackUp(1e-60)), 0);
  EXPECT_EQ(teUnpack(tePackUp(1e300)), std::numeric_limits<float>::infinity());
}

TEST(TeQuadtreeSquare, FlagsAndBlockDoNotDisturbEachOther) {
  TeQuadtreeSquare square;
  square.setBlock(TeQuadtreeSquare::kMaxBlock);
  square.set(TeQuadtreeSquare::kStatic, true);
  EXPECT_EQ(square.block(), TeQuadtreeSquare::kMaxBlock);
  square.setBlock(1);
  EXPECT_TRUE(square.has(TeQuadtreeSquare::kStatic));
  EXPECT_FALSE(square.has(TeQuadtreeSquare::kMade));
  square.set(TeQuadtreeSquare::kStatic, false);
  EXPECT_EQ(square.block(), 1u);
}

TEST(TeQuadtreeSides, QuadrantsAreAtTheirSides) {
  using Sides = TeQuadtreeSides;
  for (int k = 0; k < 4; k++) {
    EXPECT_TRUE(Sides::touches(k, Sides::isEast(k) ? Sides::kEast : Sides::kWest));
    EXPECT_TRUE(Sides::touches(k, Sides::isNorth(k) ? Sides::kNorth : Sides::kSouth));
    for (int s = 0; s < 4; s++) {
      const int across = Sides::mirrored(k, s);
      EXPECT_EQ(Sides::isEast(k) == Sides::isEast(across), Sides::kX[s] == 0);
      EXPECT_EQ(Sides::isNorth(k) == Sides::isNorth(across), Sides::kY[s] == 0);
    }
  }
}
