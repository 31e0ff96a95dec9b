#include "nodes/seamless/TeSeamlessLayout.h"

#include <gtest/gtest.h>

#include <climits>
#include <set>

namespace {

TeSeamlessLayout layout(int resolution, int minResolution, int levels) {
  return TeSeamlessLayout::create(resolution, minResolution, levels).value();
}

} // namespace

// Document 004: resolution 4096, smallest patches 16, three levels.
TEST(TeSeamlessLayout, hasTheDocumentsNumbers) {
  const TeSeamlessLayout terrain = layout(4096, 16, 3);
  EXPECT_EQ(terrain.maxResolution(), 64);
  EXPECT_EQ(terrain.branching(), 4);
  EXPECT_EQ(terrain.depth(), 4);
  EXPECT_EQ(terrain.patchCount(), 1 + 16 + 256 + 4096);
  EXPECT_EQ(layout(4096, 16, 2).branching(), 2);
  EXPECT_EQ(layout(16384, 16, 3).depth(), 5);
}

TEST(TeSeamlessLayout, parentsAndChildrenInTheArrayBelongTogether) {
  const TeSeamlessLayout terrain = layout(1024, 8, 3);
  for (std::int64_t patch = 0; patch < terrain.firstPatch(terrain.depth() - 1); patch++)
    for (std::int64_t child = 0; child < 16; child++)
      EXPECT_EQ(terrain.parent(terrain.firstChild(patch) + child), patch);
  EXPECT_EQ(terrain.firstChild(terrain.firstPatch(2) - 1) + 16, terrain.firstPatch(3));
}

TEST(TeSeamlessLayout, childrenBeginWhereParentsEnd) {
  for (const int levels : {2, 3, 4})
    for (int resolution = 32; resolution <= 8192; resolution *= 2) {
      const TeSeamlessLayout terrain = layout(resolution, 4, levels);
      for (int level = 0; level + 1 < terrain.depth(); level++) {
        EXPECT_EQ(terrain.topIndex(level), levels - 1);
        EXPECT_EQ(terrain.spacingLog(level, levels - 1), terrain.spacingLog(level + 1, 0));
      }
      const int deepest = terrain.depth() - 1;
      EXPECT_EQ(terrain.spacingLog(deepest, terrain.topIndex(deepest)), 0) << "every sample is a vertex";
      EXPECT_EQ(terrain.cells(deepest) * terrain.patchesPerSide(deepest), resolution);
    }
}

TEST(TeSeamlessLayout, aTerrainSmallerThanAPatchIsOnePatch) {
  const TeSeamlessLayout terrain = layout(32, 16, 3);
  EXPECT_EQ(terrain.depth(), 1);
  EXPECT_EQ(terrain.topIndex(0), 1);
}

TEST(TeSeamlessLayout, neighboursShareSidesAndAllAreNumbered) {
  const TeSeamlessLayout terrain = layout(256, 8, 3);
  const int level = 1;
  const std::int32_t count = terrain.patchesPerSide(level);
  std::set<std::int64_t> sides;
  const auto index = [&](std::int32_t x, std::int32_t y, TeSide side) {
    const std::int64_t i = terrain.sideIndex(TeSeamlessLayout::sideOf(level, x, y, side));
    EXPECT_GE(i, 0);
    EXPECT_LT(i, terrain.sideCount(level));
    sides.insert(i);
    return i;
  };
  for (std::int32_t y = 0; y < count; y++)
    for (std::int32_t x = 0; x < count; x++)
      for (const TeSide side : {TeNorth, TeEast, TeSouth, TeWest})
        index(x, y, side);
  EXPECT_EQ(std::int64_t(sides.size()), terrain.sideCount(level));
  EXPECT_EQ(index(1, 1, TeNorth), index(1, 2, TeSouth));
  EXPECT_EQ(index(1, 1, TeEast), index(2, 1, TeWest));
}

TEST(TeSeamlessLayout, refusesWhatCannotBeDrawn) {
  const struct {
    int resolution, minResolution, levels;
    const char* word;
  } wrong[] = {{4095, 16, 3, "4095"},          {0, 16, 3, "resolution 0"},
               {-4096, 16, 3, "-4096"},        {8, 16, 3, "resolution 8"},
               {INT_MAX, 16, 3, "2147483647"}, {1 << 30, 16, 3, "1073741824"},
               {4096, 0, 3, "minimum"},        {4096, 12, 3, "12"},
               {4096, 256, 3, "256"},          {4096, 1, 3, "minimum"},
               {4096, 16, 1, "levels 1"},      {4096, 16, 10, "levels 10"},
               {4096, INT_MIN, 3, "minimum"},  {4096, 16, INT_MAX, "levels"}};
  for (const auto& sizes : wrong) {
    const auto made = TeSeamlessLayout::create(sizes.resolution, sizes.minResolution, sizes.levels);
    ASSERT_FALSE(made.ok()) << sizes.resolution << " " << sizes.minResolution << " " << sizes.levels;
    EXPECT_NE(made.error().message.find(sizes.word), std::string::npos) << made.error().message;
  }
}
