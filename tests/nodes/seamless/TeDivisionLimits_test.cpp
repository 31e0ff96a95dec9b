#include "nodes/seamless/TeDivisionLimits.h"

#include <gtest/gtest.h>

namespace {

/// Resolutions 4 and 8 over 64 cells: patches of 64, 32, 16 and 8 cells.
TeSeamlessLayout layout() { return TeSeamlessLayout::create(64, 4, 2).value(); }

TeClipResidency whole() {
  TeClipResidency residency;
  for (int level = 0; level <= 6; level++)
    residency.windows.push_back({0, 0, (1 << level) + 1});
  return residency;
}

} // namespace

TEST(TeDivisionLimits, thereAreNoneWhereAllIsResident) {
  const TeClipResidency residency = whole();
  for (const TeClipResidency* given : {static_cast<const TeClipResidency*>(nullptr), &residency}) {
    const TeDivisionLimits limits(layout(), given);
    EXPECT_TRUE(limits.mayDivide(0, 0, 0));
    EXPECT_TRUE(limits.mayDivide(2, 3, 0));
    EXPECT_FALSE(limits.mayDivide(3, 0, 0)) << "the deepest level";
    EXPECT_EQ(limits.topIndex({3, true, 7, 8}), 1);
  }
}

TEST(TeDivisionLimits, aMissingLevelKeepsAllAboveItFromBeingDrawn) {
  TeClipResidency residency = whole();
  residency.windows[5] = {};
  const TeDivisionLimits limits(layout(), &residency);
  // Patches of tree level 1 are drawn with heights of levels 3 and 4, those of level 2 with 4 and 5.
  EXPECT_TRUE(limits.mayDivide(1, 1, 1));
  EXPECT_FALSE(limits.mayDivide(2, 1, 1));
  EXPECT_EQ(limits.topIndex({2, true, 1, 1}), 0);
}

TEST(TeDivisionLimits, patchesAreDividedWhereHeightsReachBeyondThem) {
  TeClipResidency residency = whole();
  residency.windows[5] = {7, 7, 19};
  const TeDivisionLimits limits(layout(), &residency);
  // Tree level 2 has 8 cells of height level 5 a patch: patches 1 and 2 are resident in each direction, and
  // none of them has all its neighbours.
  for (int x = 0; x < 4; x++)
    EXPECT_FALSE(limits.mayDivide(2, x, 1));
  EXPECT_EQ(limits.topIndex({2, false, 2, 1}), 1) << "both patches at the side are resident";
  EXPECT_EQ(limits.topIndex({2, false, 1, 1}), 0) << "the western one is not";

  residency.windows[5] = {0, 0, 26};
  const TeDivisionLimits wider(layout(), &residency);
  EXPECT_TRUE(wider.mayDivide(2, 0, 1)) << "at the rim of the terrain";
  EXPECT_TRUE(wider.mayDivide(2, 1, 1));
  EXPECT_FALSE(wider.mayDivide(2, 2, 1));
  EXPECT_EQ(wider.topIndex({3, true, 4, 2}), 0) << "its neighbours' parents cannot be divided";
}

TEST(TeDivisionLimits, childrenOfTheOutermostPatchesStayWhole) {
  TeClipResidency residency = whole();
  residency.windows[4] = {0, 0, 14};
  const TeDivisionLimits limits(layout(), &residency);
  // Tree level 1, 8 cells of height level 4 a patch: only (0, 0) is resident, without its neighbours.
  EXPECT_FALSE(limits.mayDivide(1, 0, 0));
  EXPECT_FALSE(limits.mayDivide(2, 0, 0));
  EXPECT_EQ(limits.topIndex({2, true, 0, 0}), 0);
}
