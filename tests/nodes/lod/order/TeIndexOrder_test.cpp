#include "nodes/lod/order/TeIndexOrder.h"

#include "nodes/lod/order/TeHilbertOrder.h"
#include "nodes/lod/order/TeVertexFifo.h"
#include "nodes/lod/order/orderMeshes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace {

using Kind = TeIndexOrder::Kind;

double missesOf(Kind kind, const TeLodMesh& mesh, int cacheSize) {
  const TeResult<std::vector<std::uint32_t>> ordered = TeIndexOrder::apply(kind, mesh.vertices, mesh.indices);
  return ordered ? TeVertexFifo::missesPerTriangle(*ordered, mesh.vertices.size(), cacheSize) : -1;
}

bool isThere(Kind kind) { return bool(TeIndexOrder::apply(kind, gridOf(1).vertices, gridOf(1).indices)); }

} // namespace

TEST(TeIndexOrder, KeepsTrianglesAndWinding) {
  // Two meshes that do not touch, and none at all.
  TeLodMesh islands = gridOf(5);
  const std::uint32_t first = std::uint32_t(islands.vertices.size());
  for (const TeLodVertex& vertex : gridOf(4).vertices)
    islands.vertices.push_back({vertex.column + 100, vertex.row, 0});
  for (const std::uint32_t index : gridOf(4).indices)
    islands.indices.push_back(first + index);
  for (const TeLodMesh& mesh :
       {gridOf(1), gridOf(20), islands, irregularMesh(64, 1), irregularMesh(64, 1000), TeLodMesh()})
    for (const Kind kind : TeIndexOrder::all()) {
      if (!isThere(kind))
        continue;
      const auto ordered = TeIndexOrder::apply(kind, mesh.vertices, mesh.indices);
      EXPECT_EQ(sortedTriangles(*ordered), sortedTriangles(mesh.indices)) << TeIndexOrder::name(kind);
      EXPECT_EQ(*ordered, *TeIndexOrder::apply(kind, mesh.vertices, mesh.indices));
    }
}

// Every vertex is transformed once at least, and three times a triangle at most.
TEST(TeIndexOrder, MissesStayBetweenTheirBounds) {
  for (const TeLodMesh& mesh : {gridOf(33), irregularMesh(128, 1)})
    for (const Kind kind : TeIndexOrder::all()) {
      if (!isThere(kind))
        continue;
      double before = 3;
      for (const int size : {8, 16, 64, 1024, 100000}) {
        const double misses = missesOf(kind, mesh, size);
        EXPECT_GE(misses, 0.5);
        EXPECT_LE(misses, before * 1.02) << TeIndexOrder::name(kind); // hardly ever more with more room
        before = misses;
      }
      EXPECT_DOUBLE_EQ(before, double(mesh.vertices.size()) / double(mesh.triangles()));
    }
}

TEST(TeIndexOrder, BeatsRowsOfAGrid) {
  const TeLodMesh grid = gridOf(64);
  EXPECT_NEAR(missesOf(Kind::AsMade, grid, 16), 65.0 / 64, 1e-12);
  EXPECT_NEAR(missesOf(Kind::Strips, grid, 16), 1, 0.03); // a new vertex a triangle
  EXPECT_LT(missesOf(Kind::CacheAware, grid, TeIndexOrder::kCacheSize), 0.7);
  EXPECT_LT(missesOf(Kind::Hilbert, grid, 16), 0.8);
  EXPECT_LT(missesOf(Kind::Hilbert, grid, 32), 0.7);
  EXPECT_LT(missesOf(Kind::Oblivious, grid, 32), 0.72);
  if (isThere(Kind::VertexCache)) {
    EXPECT_LT(missesOf(Kind::VertexCache, grid, 16), 0.7);
  } else {
    const auto result = TeIndexOrder::apply(Kind::VertexCache, grid.vertices, grid.indices);
    EXPECT_NE(result.error().message.find("meshoptimizer"), std::string::npos);
  }
}

// The curve goes through every cell once, from each to one beside it.
TEST(TeHilbertOrder, IsACurve) {
  constexpr std::uint32_t kSide = 64, kCell = 65536 / kSide;
  std::vector<std::pair<std::uint32_t, std::pair<int, int>>> cells;
  for (std::uint32_t y = 0; y < kSide; y++)
    for (std::uint32_t x = 0; x < kSide; x++)
      cells.push_back({TeHilbertOrder::along(x * kCell, y * kCell) / (kCell * kCell), {int(x), int(y)}});
  std::sort(cells.begin(), cells.end());
  for (std::uint32_t i = 0; i < cells.size(); i++) {
    ASSERT_EQ(cells[i].first, i);
    if (i > 0) {
      ASSERT_EQ(std::abs(cells[i].second.first - cells[i - 1].second.first) +
                    std::abs(cells[i].second.second - cells[i - 1].second.second),
                1);
    }
  }
}
