#include "nodes/seamless/TeSeamlessMesh.h"
#include "nodes/seamless/TeSeamlessTerrain.h"
#include "nodes/seamless/hillsNode.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int kResolution = 128;
constexpr double kSpacing = 8; ///< metres
constexpr double kWanted = 3;  ///< pixels
constexpr int kFrames = 600;

/// What is drawn at a sample.
struct Drawn {
  float height = 0;
  bool isVertex = false;
};

std::size_t numberOf(int column, int row) {
  return std::size_t(row) * (kResolution + 1) + std::size_t(column);
}

std::vector<Drawn> drawnAt(const TeSeamlessTerrain& terrain, const TeSeamlessSelection& selection) {
  std::vector<Drawn> drawn(std::size_t(kResolution + 1) * (kResolution + 1));
  const TeSeamlessMapHeights samples(terrain.map.get());
  std::vector<TeSeamlessMesh::Triangle> triangles;
  for (const TeSeamlessPatch& patch : selection.patches)
    TeSeamlessMesh::appendPatch(patch, terrain.layout, *terrain.parts, samples, triangles);
  for (const TeSeamlessMesh::Triangle& t : triangles) {
    const double area = double(t.b.column - t.a.column) * (t.c.row - t.a.row) -
                        double(t.c.column - t.a.column) * (t.b.row - t.a.row);
    const auto [west, east] = std::minmax({t.a.column, t.b.column, t.c.column});
    const auto [south, north] = std::minmax({t.a.row, t.b.row, t.c.row});
    for (int y = south; y <= north; y++) {
      for (int x = west; x <= east; x++) {
        const double b =
            (double(x - t.a.column) * (t.c.row - t.a.row) - double(t.c.column - t.a.column) * (y - t.a.row)) /
            area;
        const double c =
            (double(t.b.column - t.a.column) * (y - t.a.row) - double(x - t.a.column) * (t.b.row - t.a.row)) /
            area;
        if (b >= 0 && c >= 0 && b + c <= 1)
          drawn[numberOf(x, y)].height =
              float(double(t.a.height) * (1 - b - c) + double(t.b.height) * b + double(t.c.height) * c);
      }
    }
    for (const TeSeamlessMesh::Vertex& vertex : {t.a, t.b, t.c})
      drawn[numberOf(vertex.column, vertex.row)].isVertex = true;
  }
  return drawn;
}

/// Largest changes from one frame of a flight to the next, and the largest error stated; pixels.
struct Changes {
  double vertices = 0; ///< at samples that are vertices before and after
  double surface = 0;  ///< at all samples
  double bound = 0;
};

Changes fly(const TeSeamlessTerrain& terrain, bool geomorph) {
  TeSeamlessPlacement placement;
  placement.spacing = kSpacing;
  placement.range = terrain.range;
  TeSeamlessAccuracy accuracy;
  accuracy.pixelError = kWanted;
  accuracy.geomorph = geomorph;
  TeLodView view;
  view.focal = 665.1;
  TeSeamlessSelection selection;
  std::vector<Drawn> before;
  Changes changes;
  for (int i = 0; i < kFrames; i++) {
    view.eye = {100 + 1.0 * i, 80 + 0.7 * i, 9000 - 12.5 * i};
    terrain.selector.select(view, placement, accuracy, nullptr, selection);
    changes.bound = std::max(changes.bound, selection.errorBound);
    std::vector<Drawn> after = drawnAt(terrain, selection);
    for (int row = 0; row <= kResolution && !before.empty(); row++) {
      for (int column = 0; column <= kResolution; column++) {
        const Drawn &old = before[numberOf(column, row)], &now = after[numberOf(column, row)];
        const glm::dvec3 at(column * kSpacing, row * kSpacing, double(now.height));
        const double pixels =
            view.pixels(std::abs(double(now.height - old.height)), glm::length(at - view.eye));
        changes.surface = std::max(changes.surface, pixels);
        if (old.isVertex && now.isVertex)
          changes.vertices = std::max(changes.vertices, pixels);
      }
    }
    before = std::move(after);
  }
  return changes;
}

} // namespace

// Flying down on hills. Geomorphing: a change of resolution moves no vertex by more than a part
// of the stated error from one frame to the next. Where children take the place of a patch, diagonals of
// cells turn, so within cells the surface may change; as without geomorphing, from one side of the true
// surface to the other at most.
TEST(HardCase, PoppingSeamless) {
  const auto layout = TeSeamlessLayout::create(kResolution, 4, 3);
  const auto terrain =
      TeSeamlessTerrain::create(*layout, std::make_shared<const TeHeightMap>(hillsMap(kResolution)));
  ASSERT_TRUE(terrain);
  const Changes plain = fly(**terrain, false);
  const Changes morphed = fly(**terrain, true);
  EXPECT_LE(plain.bound, kWanted);
  EXPECT_LE(morphed.bound, kWanted);
  EXPECT_LE(plain.surface, 2 * plain.bound);
  EXPECT_LE(morphed.surface, 2 * morphed.bound);
  EXPECT_LE(morphed.vertices, 0.5 * morphed.bound);
  EXPECT_GT(morphed.vertices, 0); // they do morph
  std::printf(
      "%d frames, bound %.1f px: with geomorphing vertices move by up to %.2f px a frame; the surface "
      "by %.2f px, without it %.2f px\n",
      kFrames, morphed.bound, morphed.vertices, morphed.surface, plain.surface);
}
