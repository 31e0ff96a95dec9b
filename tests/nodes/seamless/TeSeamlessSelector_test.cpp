#include "nodes/seamless/TeSeamlessSelector.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

namespace {

TeSeamlessLayout layout(int resolution, int minResolution, int levels) {
  return TeSeamlessLayout::create(resolution, minResolution, levels).value();
}

void expectWatertight(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
                      const TeSeamlessParts& parts, TeWatertight& mesh) {
  meshOf(selection, layout, parts, mesh);
  ASSERT_EQ(mesh.cracks(), 0);
  ASSERT_EQ(mesh.slivers(), 0);
  ASSERT_TRUE(mesh.coversSquare());
}

/// Fails if a part needs a height that is not resident.
class ResidentHeights final : public TeSeamlessHeights {
public:
  ResidentHeights(const TeClipResidency& residency, int resolutionLog)
      : m_residency(residency), m_resolutionLog(resolutionLog) {}
  float height(std::int32_t column, std::int32_t row, int level) const override {
    const int shift = m_resolutionLog - level;
    EXPECT_EQ(column & ((1 << shift) - 1), 0);
    EXPECT_EQ(row & ((1 << shift) - 1), 0);
    EXPECT_TRUE(m_residency.holds(level, column >> shift, row >> shift, column >> shift, row >> shift));
    return 0;
  }

private:
  const TeClipResidency& m_residency;
  int m_resolutionLog;
};

} // namespace

TEST(TeSeamlessSelector, precisionLeavesNoCracks) {
  std::mt19937 random(1);
  const std::vector<TeSeamlessLayout> layouts = {layout(256, 4, 2), layout(256, 4, 3), layout(512, 2, 4),
                                                 layout(128, 8, 2)};
  for (const TeSeamlessLayout& terrain : layouts) {
    const TeSeamlessSelector selector(terrain, nullptr);
    const TeSeamlessParts parts(terrain);
    TeWatertight mesh(terrain.resolution());
    TeSeamlessSelection selection;
    TeSeamlessPlacement placement;
    placement.spacing = 10;
    placement.range = {0, 300};
    for (int i = 0; i < 200; i++) {
      TeSeamlessAccuracy accuracy;
      accuracy.precision = i % 3 == 0 ? 1 : 1 + double(random() % 1000) / 300;
      accuracy.geomorph = i % 2 == 1;
      const double side = terrain.resolution() * placement.spacing;
      const TeLodView view = viewFrom(anyEye(random, side, 300));
      SCOPED_TRACE(testing::Message()
                   << "camera " << i << " levels " << terrain.levels() << " p " << accuracy.precision);
      selector.select(view, placement, accuracy, nullptr, selection);
      expectWatertight(selection, terrain, parts, mesh);
      if (HasFatalFailure())
        return;
    }
  }
}

TEST(TeSeamlessSelector, drawsWhatIsResidentWithoutCracks) {
  std::mt19937 random(2);
  std::int64_t limited = 0;
  for (const TeSeamlessLayout& terrain : {layout(1024, 4, 2), layout(1024, 4, 3), layout(512, 2, 3)}) {
    const TeSeamlessSelector selector(terrain, nullptr);
    const TeSeamlessParts parts(terrain);
    TeWatertight mesh(terrain.resolution());
    TeSeamlessSelection selection, unlimited;
    TeSeamlessPlacement placement;
    std::vector<TeSeamlessMesh::Triangle> triangles;
    for (int i = 0; i < 200; i++) {
      TeSeamlessAccuracy accuracy;
      accuracy.precision = 1 + double(random() % 1000) / 300;
      accuracy.geomorph = i % 2 == 1;
      const TeLodView view = viewFrom(anyEye(random, terrain.resolution(), 30));
      const TeClipResidency residency = anyResidency(random, terrain, 5 + i % 2, {view.eye.x, view.eye.y});
      SCOPED_TRACE(testing::Message() << "camera " << i << " levels " << terrain.levels());
      selector.select(view, placement, accuracy, &residency, selection);
      selector.select(view, placement, accuracy, nullptr, unlimited);
      limited += selection.triangles < unlimited.triangles;
      expectWatertight(selection, terrain, parts, mesh);
      const ResidentHeights heights(residency, terrain.resolutionLog());
      triangles.clear();
      for (const TeSeamlessPatch& patch : selection.patches)
        TeSeamlessMesh::appendPatch(patch, terrain, parts, heights, triangles);
      EXPECT_EQ(std::int64_t(triangles.size()), selection.triangles);
      if (HasFailure())
        return;
    }
  }
  EXPECT_GT(limited, 100) << "windows mattered";
}

TEST(TeSeamlessSelector, whatIsNotInViewIsCulledAndChangesNothingElse) {
  std::mt19937 random(3);
  const TeSeamlessLayout terrain = layout(1024, 4, 3);
  const TeSeamlessSelector selector(terrain, nullptr);
  TeSeamlessPlacement placement;
  placement.range = {0, 50};
  TeSeamlessSelection all, seen;
  for (int i = 0; i < 100; i++) {
    TeLodView view = viewFrom(anyEye(random, terrain.resolution(), 30));
    selector.select(view, placement, TeSeamlessAccuracy(), nullptr, all);
    lookAlong(view, {std::cos(i), std::sin(i), -0.2}, 0.5);
    selector.select(view, placement, TeSeamlessAccuracy(), nullptr, seen);
    std::size_t next = 0;
    for (const TeSeamlessPatch& patch : all.patches) {
      const double size = terrain.cells(patch.level);
      // What only touches the edge of the view may be drawn or not.
      const double edge = 1e-9;
      const bool inView = view.meets({patch.x * size + edge, patch.y * size + edge, edge},
                                     {(patch.x + 1) * size - edge, (patch.y + 1) * size - edge, 50 - edge});
      if (next < seen.patches.size() && seen.patches[next].level == patch.level &&
          seen.patches[next].x == patch.x && seen.patches[next].y == patch.y) {
        EXPECT_EQ(seen.patches[next].detail, patch.detail);
        next++;
      } else {
        EXPECT_FALSE(inView);
      }
    }
    EXPECT_EQ(next, seen.patches.size());
  }
}

// Counted by the parts themselves.
TEST(TeSeamlessSelector, countsTriangles) {
  const TeSeamlessLayout terrain = layout(256, 4, 3);
  const TeSeamlessParts parts(terrain);
  TeSeamlessSelection selection;
  TeSeamlessSelector(terrain, nullptr)
      .select(viewFrom({100, 40, 20}), TeSeamlessPlacement(), TeSeamlessAccuracy(), nullptr, selection);
  std::int64_t indices = 0;
  for (const TeSeamlessPatch& patch : selection.patches)
    for (int side = 0; side < 4; side++)
      indices += parts.tile(side, patch.resolution(side)).count +
                 parts.strip(side, patch.resolution(side), patch.resolution((side + 1) % 4)).count;
  EXPECT_EQ(selection.triangles * 3, indices);
  EXPECT_GT(selection.triangles, 1000);
}

// A parallel view of a high-piled terrain wants every sample, of which there are too many; then it is coarser
// than the document's precision 1 would have it, and fits.
TEST(TeSeamlessSelector, parallelViewsKeepTheBudgetOfPatches) {
  const TeSeamlessLayout terrain = layout(1024, 4, 3);
  const TeSeamlessParts parts(terrain);
  TeWatertight mesh(terrain.resolution());
  TeLodView view = viewFrom({500, 500, 1e6}, 1e6);
  view.perspective = false;
  for (const bool geomorph : {false, true}) {
    TeSeamlessAccuracy accuracy;
    accuracy.geomorph = geomorph;
    accuracy.maxPatches = 100;
    TeSeamlessSelection selection;
    TeSeamlessSelector(terrain, nullptr).select(view, TeSeamlessPlacement(), accuracy, nullptr, selection);
    EXPECT_LE(selection.patches.size(), 100u);
    EXPECT_GT(selection.patches.size(), 5u);
    EXPECT_GT(selection.coarsening, 1);
    expectWatertight(selection, terrain, parts, mesh);
  }
}

// Heights of no height have no error, wherever the eye is.
TEST(TeSeamlessSelector, terrainThatIsPressedFlatIsDrawnByItsErrors) {
  std::mt19937 random(5);
  const TeSeamlessLayout terrain = layout(256, 4, 3);
  const TeSeamlessSelector selector(
      terrain, TeSeamlessBounds::create(terrain, stressMap(StressField::Rough, 256, random)).value());
  TeSeamlessPlacement placement;
  placement.heightScale = 0;
  for (const bool geomorph : {false, true}) {
    TeSeamlessAccuracy accuracy;
    accuracy.pixelError = 1;
    accuracy.geomorph = geomorph;
    TeSeamlessSelection selection;
    selector.select(viewFrom({100, 60, 0}), placement, accuracy, nullptr, selection);
    ASSERT_EQ(selection.patches.size(), 1u);
    for (const float detail : selection.patches[0].detail)
      EXPECT_EQ(detail, 0);
    EXPECT_EQ(selection.errorBound, 0);
  }
}
