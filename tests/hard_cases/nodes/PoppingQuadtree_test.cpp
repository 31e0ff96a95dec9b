#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int kCells = 128;
constexpr double kSpacing = 8; ///< metres
constexpr double kWanted = 3;  ///< pixels
constexpr int kFrames = 600;

TeHeightMap hills() {
  TeHeightMap map = TeHeightMap::create(kCells + 1, kCells + 1).value();
  for (int row = 0; row <= kCells; row++)
    for (int column = 0; column <= kCells; column++) {
      const double u = double(column) / kCells, v = double(row) / kCells;
      map.at(column, row) = float(100 + 35 * std::sin(28 * u) * std::cos(18 * v + 1) +
                                  10 * std::sin(90 * u + 40 * v) * std::cos(100 * v));
    }
  return map;
}

std::size_t numberOf(int column, int row) { return std::size_t(row) * (kCells + 1) + std::size_t(column); }

/// Heights of what is drawn at all samples.
std::vector<float> drawnAt(const TeQuadtreeMesh& quadtree) {
  std::vector<float> drawn(std::size_t(kCells + 1) * (kCells + 1));
  TeLodMesh mesh;
  quadtree.append(mesh);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const TeLodVertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                      &c = mesh.vertices[mesh.indices[i + 2]];
    const double bx = b.column - a.column, by = b.row - a.row;
    const double cx = c.column - a.column, cy = c.row - a.row;
    const double area = bx * cy - cx * by;
    const auto [west, east] = std::minmax({a.column, b.column, c.column});
    const auto [south, north] = std::minmax({a.row, b.row, c.row});
    for (int y = south; y <= north; y++)
      for (int x = west; x <= east; x++) {
        const double u = ((x - a.column) * cy - cx * (y - a.row)) / area;
        const double v = (bx * (y - a.row) - (x - a.column) * by) / area;
        if (u >= 0 && v >= 0 && u + v <= 1)
          drawn[numberOf(x, y)] =
              float(double(a.height) * (1 - u - v) + double(b.height) * u + double(c.height) * v);
      }
  }
  return drawn;
}

/// Largest change of the surface from one frame of a flight to the next, and the largest error stated;
/// pixels.
struct Flight {
  double change = 0;
  double bound = 0;
  double triangles = 0; ///< a frame
};

Flight fly(const TeQuadtree& tree, bool geomorph) {
  TeQuadtreeMesh mesh(tree, TeLodField::Placement{{}, kSpacing, 1});
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = kWanted;
  wish.geomorph = geomorph;
  TeLodView view;
  view.focal = 665.1;
  std::vector<float> before;
  Flight flight;
  for (int frame = 0; frame < kFrames; frame++) {
    view.eye = {100 + 1.0 * frame, 80 + 0.7 * frame, 9000 - 12.5 * frame};
    mesh.update(view, wish);
    flight.bound = std::max(flight.bound, mesh.result().errorBound);
    flight.triangles += double(mesh.result().triangles) / kFrames;
    std::vector<float> after = drawnAt(mesh);
    for (int row = 0; row <= kCells && !before.empty(); row++)
      for (int column = 0; column <= kCells; column++) {
        const double now = double(after[numberOf(column, row)]);
        const glm::dvec3 at(column * kSpacing, row * kSpacing, now);
        const double moved = std::fabs(now - double(before[numberOf(column, row)]));
        flight.change = std::max(flight.change, view.pixels(moved, glm::length(at - view.eye)));
      }
    before = std::move(after);
  }
  return flight;
}

} // namespace

// Flying down on hills: the surface changes at once by no more than the error of before and after together.
// With geomorphing every change begins on the surface as it was.
TEST(HardCase, PoppingQuadtree) {
  const TeQuadtree tree = TeQuadtree::create(hills()).value();
  const Flight plain = fly(tree, false);
  const Flight morphed = fly(tree, true);
  std::printf(
      "%d frames, bound %.2f px: the surface changes by up to %.2f px a frame, of %.0f triangles; with "
      "geomorphing (bound %.2f px) by %.2f px, of %.0f\n",
      kFrames, plain.bound, plain.change, plain.triangles, morphed.bound, morphed.change, morphed.triangles);
  EXPECT_LE(plain.bound, kWanted);
  EXPECT_LE(morphed.bound, kWanted);
  EXPECT_LE(plain.change, 2 * plain.bound);
  EXPECT_LE(morphed.change, 0.1 * kWanted);
  EXPECT_GT(morphed.change, 0);
}
