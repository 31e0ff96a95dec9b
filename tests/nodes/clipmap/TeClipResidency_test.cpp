#include "nodes/clipmap/TeClipResidency.h"

#include <gtest/gtest.h>

TEST(TeClipResidency, HoldsWhatLiesInAWindowAndAllBelowTheBase) {
  TeClipResidency residency;
  residency.base = 3;
  residency.windows = {{0, 0, 9}, {4, 6, 9}, {0, 0, 0}};
  EXPECT_EQ(residency.top(), 5);
  EXPECT_TRUE(residency.holds(0, 0, 0, 1, 1));
  EXPECT_TRUE(residency.holds(3, 0, 0, 8, 8));
  EXPECT_TRUE(residency.holds(4, 4, 6, 12, 14));
  EXPECT_FALSE(residency.holds(4, 3, 6, 12, 14));
  EXPECT_FALSE(residency.holds(4, 4, 6, 13, 14));
  EXPECT_FALSE(residency.holds(4, 4, 6, 12, 15));
  EXPECT_FALSE(residency.holds(5, 0, 0, 0, 0)) << "not up to date";
  EXPECT_FALSE(residency.holds(6, 8, 8, 8, 8)) << "not there";
}

TEST(TeClipResidency, WithoutABaseThereIsNothing) {
  TeClipResidency residency;
  EXPECT_FALSE(residency.holds(0, 0, 0, 1, 1));
  residency.windows = {{0, 0, 0}};
  EXPECT_FALSE(residency.holds(0, 0, 0, 1, 1));
}
