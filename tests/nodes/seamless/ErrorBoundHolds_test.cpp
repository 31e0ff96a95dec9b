#include "nodes/clipmap/TeClipFormat.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace {

constexpr int kTrials = 40;

struct Tally {
  int frames = 0;
  int wanted = 0;     ///< frames with a wanted pixel error that there was detail for
  double closest = 0; ///< largest ratio of true error and bound
  double ratios = 0;  ///< their sum
};

TeScreenError::Report measured(const TeSeamlessSelection& selection, const TeSeamlessLayout& layout,
                               const TeSeamlessParts& parts, const TeSeamlessHeights& heights,
                               const TeLodView& view, TeScreenError& error) {
  std::vector<TeSeamlessMesh::Triangle> triangles;
  for (const TeSeamlessPatch& patch : selection.patches)
    TeSeamlessMesh::appendPatch(patch, layout, parts, heights, triangles);
  EXPECT_EQ(std::int64_t(triangles.size()), selection.triangles);
  error.clear();
  const auto vertex = [](const TeSeamlessMesh::Vertex& v) {
    return TeScreenError::Vertex{v.column, v.row, v.height};
  };
  for (const TeSeamlessMesh::Triangle& triangle : triangles)
    error.add(vertex(triangle.a), vertex(triangle.b), vertex(triangle.c));
  return error.measure(view);
}

/// Whole numbers as a texture of halves has them.
class HalfHeights final : public TeSeamlessHeights {
public:
  explicit HalfHeights(const TeHeightMap& map) : m_map(map) {}
  float height(std::int32_t column, std::int32_t row, int) const override {
    return teDrawnHeight(std::uint16_t(m_map.at(column, row)), TeClipFormat::Half);
  }

private:
  const TeHeightMap& m_map;
};

} // namespace

// Over all samples in view: each is drawn once, and none is off by more than the frame says, which is no more
// than was asked for where all heights are resident.
TEST(SeamlessSelection, ErrorBoundHolds) {
  std::mt19937 random(20);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Tally tally;
  for (const auto& [resolution, minResolution, levels] :
       std::vector<std::array<int, 3>>{{256, 4, 3}, {256, 2, 2}, {128, 2, 5}, {256, 16, 3}}) {
    const TeSeamlessLayout layout = TeSeamlessLayout::create(resolution, minResolution, levels).value();
    const TeSeamlessParts parts(layout);
    for (int field = 0; field <= int(StressField::Flat); field++) {
      const TeHeightMap map = stressMap(StressField(field), resolution, random);
      const TeSeamlessSelector selector(layout, TeSeamlessBounds::create(layout, map).value());
      TeSeamlessPlacement placement;
      placement.corner = {uniform(-1e4, 1e4), uniform(-1e4, 1e4), uniform(-100, 100)};
      placement.spacing = uniform(0.5, 20);
      placement.heightScale = uniform(0.01, 2);
      placement.range = selector.bounds()->range(0, 0, 0);
      TeScreenError error(map, placement.corner, placement.spacing, placement.heightScale);
      const double side = resolution * placement.spacing;
      for (int trial = 0; trial < kTrials; trial++) {
        TeLodView view = viewFrom(placement.corner + anyEye(random, side, 0.3 * side), uniform(100, 3000));
        if (random() % 3 != 0)
          lookAlong(view, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)}, uniform(0.05, 1.4));
        view.perspective = random() % 8 != 0;
        if (!view.perspective)
          view.focal = uniform(0.01, 10);
        TeSeamlessAccuracy accuracy;
        accuracy.precision = uniform(1, 8);
        accuracy.pixelError = random() % 3 == 0 ? 0 : std::exp(uniform(-1, 5));
        accuracy.geomorph = random() % 2 == 0;
        const bool whole = random() % 3 != 0;
        TeClipResidency residency;
        if (!whole)
          residency = anyResidency(random, layout, 5, {uniform(0, resolution), uniform(0, resolution)});
        TeSeamlessSelection selection;
        selector.select(view, placement, accuracy, whole ? nullptr : &residency, selection);
        TeLodView inside = view; // not what lies on a plane but for rounding
        for (glm::dvec4& plane : inside.planes)
          plane.w -= 1e-6;
        const TeScreenError::Report report =
            measured(selection, layout, parts, TeSeamlessMapHeights(&map), inside, error);
        SCOPED_TRACE("layout " + std::to_string(minResolution) + " " + std::to_string(levels) + ", field " +
                     std::to_string(field) + ", trial " + std::to_string(trial));
        ASSERT_EQ(report.uncovered, 0);
        ASSERT_EQ(report.overlaps, 0);
        ASSERT_EQ(report.foreign, 0);
        // Morphed heights are rounded.
        const glm::dvec3 worst =
            placement.corner +
            glm::dvec3(report.worstColumn * placement.spacing, report.worstRow * placement.spacing,
                       double(map.at(report.worstColumn, report.worstRow)) * placement.heightScale);
        const double largest = std::max(std::fabs(placement.range.low), std::fabs(placement.range.high));
        const double rounding =
            view.pixels(0x1p-22 * largest * placement.heightScale, glm::distance(view.eye, worst));
        ASSERT_LE(report.worst, selection.errorBound * (1 + 1e-6) + rounding);
        tally.frames++;
        if (accuracy.pixelError > 0 && whole && selection.coarsening == 1) {
          tally.wanted++;
          ASSERT_LE(selection.errorBound, accuracy.pixelError * (1 + 1e-6));
        }
        if (selection.errorBound > 0 && std::isfinite(selection.errorBound)) {
          tally.ratios += report.worst / selection.errorBound;
          tally.closest = std::max(tally.closest, report.worst / selection.errorBound);
        }
      }
    }
  }
  EXPECT_GT(tally.wanted, tally.frames / 3);
  std::printf("SeamlessSelection.ErrorBoundHolds: %d frames, %d of them within the wanted error; true error "
              "on average %.2f of the bound, at most %.4f\n",
              tally.frames, tally.wanted, tally.ratios / tally.frames, tally.closest);
}

// Also where textures round the heights: even all vertices are then off.
TEST(SeamlessSelection, ErrorBoundHoldsOfRoundedHeights) {
  std::mt19937 random(6);
  const TeSeamlessLayout layout = TeSeamlessLayout::create(128, 4, 3).value();
  TeHeightMap map = TeHeightMap::create(129, 129).value();
  for (int y = 0; y < 129; y++)
    for (int x = 0; x < 129; x++)
      map.at(x, y) = float(45000 + random() % 999);
  const TeSeamlessSelector selector(layout, TeSeamlessBounds::create(layout, map).value());
  const TeSeamlessParts parts(layout);
  TeSeamlessPlacement placement;
  placement.heightScale = 0.01;
  TeScreenError error(map, placement.corner, placement.spacing, placement.heightScale);
  TeSeamlessAccuracy accuracy;
  accuracy.rounding = double(teDrawnRounding(TeClipFormat::Half));
  TeSeamlessSelection selection;
  for (const bool exact : {false, true}) {
    accuracy.exact = exact;
    const TeLodView view = viewFrom({60, 70, 600});
    selector.select(view, placement, accuracy, nullptr, selection);
    const double worst = measured(selection, layout, parts, HalfHeights(map), view, error).worst;
    EXPECT_GT(worst, exact ? 0.1 : 1);
    EXPECT_LE(worst, selection.errorBound * (1 + 1e-6));
    EXPECT_LT(selection.errorBound, 3 * worst);
  }
}
