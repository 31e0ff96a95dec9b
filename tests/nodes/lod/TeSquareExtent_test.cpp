#include "nodes/lod/TeSquareExtent.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TeSquareExtent, LiesAroundItsMiddle) {
  const auto placed = TeSquareExtent{64, 1, false}.place({320, 320, 0}, {1000, -500, 7});
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->spacing, 5);
  EXPECT_EQ(placed->corner, glm::dvec3(840, -660, 7));
  EXPECT_EQ(placed->heightScale, 1);
}

TEST(TeSquareExtent, NoExtentsAreTheHeightsOwn) {
  const auto placed = TeSquareExtent{4, 30, false}.place({0, 0, 123}, {0, 0, 0});
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->spacing, 30);
  EXPECT_EQ(placed->corner.x, -60);
}

TEST(TeSquareExtent, NumbersAreScaledToTheHeight) {
  EXPECT_EQ((TeSquareExtent{4, 1, true}.place({8, 8, 655.35}, {0, 0, 0})->heightScale), 655.35 / 65535);
}

TEST(TeSquareExtent, WhatIsNoExtentIsAnError) {
  const TeSquareExtent extent{4, 1, false};
  const double nan = std::nan("");
  EXPECT_FALSE(extent.place({8, 9, 1}, {0, 0, 0}));
  EXPECT_FALSE(extent.place({-8, -8, 1}, {0, 0, 0}));
  EXPECT_FALSE(extent.place({8, 8, -1}, {0, 0, 0}));
  EXPECT_FALSE(extent.place({nan, nan, 1}, {0, 0, 0}));
  EXPECT_FALSE(extent.place({2e9, 2e9, 1}, {0, 0, 0}));
  EXPECT_FALSE(extent.place({8, 8, 1}, {nan, 0, 0}));
  EXPECT_FALSE(extent.place({8, 8, 1}, {0, INFINITY, 0}));
}
