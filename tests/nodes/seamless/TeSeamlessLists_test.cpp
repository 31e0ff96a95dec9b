#include "nodes/seamless/TeSeamlessLists.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

static_assert(sizeof(TeSeamlessInstance) == 16, "what is uploaded for each part");

// Each part of each patch exactly once, with the triangles of its resolutions.
TEST(TeSeamlessLists, holdEachPartOnce) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(512, 4, 3).value();
  const TeSeamlessParts parts(layout);
  TeSeamlessSelection selection;
  TeSeamlessSelector(layout, nullptr)
      .select(viewFrom({200, 130, 20}), TeSeamlessPlacement(), TeSeamlessAccuracy(), nullptr, selection);
  TeSeamlessLists lists;
  lists.build(selection, layout, parts);
  ASSERT_EQ(lists.instances().size(), 8 * selection.patches.size());

  std::set<std::tuple<int, int, int, int, int>> seen;
  std::int64_t triangles = 0;
  std::int32_t next = 0;
  for (const TeSeamlessDraw& draw : lists.draws()) {
    EXPECT_EQ(draw.firstInstance, next);
    next += draw.instanceCount;
    triangles += std::int64_t(draw.part.count) / 3 * draw.instanceCount;
    for (std::int32_t i = draw.firstInstance; i < next; i++) {
      const TeSeamlessInstance& instance = lists.instances()[std::size_t(i)];
      EXPECT_TRUE(seen.insert({instance.column, instance.row, instance.cellsLog, draw.kind, draw.orientation})
                      .second);
    }
  }
  EXPECT_EQ(triangles, selection.triangles);
  EXPECT_EQ(seen.size(), lists.instances().size());
}

TEST(TeSeamlessLists, areNoMoreThanTheDocumentsLists) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(4096, 16, 3).value();
  const TeSeamlessParts parts(layout);
  TeSeamlessSelection selection;
  TeSeamlessAccuracy accuracy;
  accuracy.precision = 8;
  TeSeamlessSelector(layout, nullptr)
      .select(viewFrom({2000, 2100, 20}), TeSeamlessPlacement(), accuracy, nullptr, selection);
  TeSeamlessLists lists;
  lists.build(selection, layout, parts);
  EXPECT_LE(lists.draws().size(), 4u * 3 * 4);
  EXPECT_GT(lists.instances().size(), 1000u);
}

// The same triangles, with an eighth of the instances and few calls.
TEST(TeSeamlessLists, holdEachPatchOnceIfDrawnWhole) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(4096, 16, 3).value();
  const TeSeamlessParts parts(layout, true);
  ASSERT_TRUE(parts.hasWholePatches());
  TeSeamlessSelection selection;
  TeSeamlessAccuracy accuracy;
  accuracy.precision = 4;
  accuracy.geomorph = true;
  TeSeamlessSelector(layout, nullptr)
      .select(viewFrom({2000, 2100, 20}), TeSeamlessPlacement(), accuracy, nullptr, selection);
  TeSeamlessLists lists;
  lists.build(selection, layout, parts);
  ASSERT_EQ(lists.instances().size(), selection.patches.size());
  std::int64_t triangles = 0;
  std::set<std::tuple<int, int, int>> seen;
  for (const TeSeamlessDraw& draw : lists.draws()) {
    EXPECT_EQ(draw.kind, TeSeamlessDraw::Patch);
    triangles += std::int64_t(draw.part.count) / 3 * draw.instanceCount;
    for (std::int32_t i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; i++) {
      const TeSeamlessInstance& instance = lists.instances()[std::size_t(i)];
      EXPECT_TRUE(seen.insert({instance.column, instance.row, instance.cellsLog}).second);
      const auto patch = std::find_if(
          selection.patches.begin(), selection.patches.end(), [&](const TeSeamlessPatch& candidate) {
            const int cellsLog = layout.cellsLog(candidate.level);
            return cellsLog == instance.cellsLog && candidate.x << cellsLog == instance.column &&
                   candidate.y << cellsLog == instance.row;
          });
      ASSERT_NE(patch, selection.patches.end());
      for (int side = 0; side < 4; side++) {
        EXPECT_EQ(patch->resolution(side), draw.indices[std::size_t(side)]);
        EXPECT_EQ(teDetailWeight(patch->detail[std::size_t(side)]), instance.weight(side));
      }
    }
  }
  EXPECT_EQ(triangles, selection.triangles);
  EXPECT_LT(lists.draws().size(), 25u);
}
