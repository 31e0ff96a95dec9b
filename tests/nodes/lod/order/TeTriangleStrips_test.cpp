#include "nodes/lod/order/TeTriangleStrips.h"

#include "nodes/lod/order/orderMeshes.h"

#include <gtest/gtest.h>

namespace {

using Indices = std::vector<std::uint32_t>;

/// Triangles of a sphere-like mesh with vertices of any degree: an icosahedron.
Indices icosahedron() {
  return {0, 1, 2, 0, 2, 3, 0, 3, 4,  0, 4,  5, 0, 5,  1, 1,  6, 2, 2,  6, 7, 2,  7, 3, 3,  7,  8, 3,  8, 4,
          4, 8, 9, 4, 9, 5, 5, 9, 10, 5, 10, 1, 1, 10, 6, 11, 7, 6, 11, 8, 7, 11, 9, 8, 11, 10, 9, 11, 6, 10};
}

} // namespace

TEST(TeTriangleStrips, HoldEveryTriangleOnceAcrossEdges) {
  for (const TeLodMesh& mesh : {gridOf(1), gridOf(13), irregularMesh(64, 1), irregularMesh(64, 8)}) {
    const TeDualGraph graph(mesh.indices);
    for (const std::int32_t longest : {0, 1, 2, 9}) {
      const TeTriangleStrips strips = TeTriangleStrips::create(mesh.indices, longest);
      EXPECT_EQ(sortedTriangles(strips.triangles(mesh.indices)), sortedTriangles(mesh.indices));
      for (const std::vector<std::int32_t>& strip : strips.strips()) {
        ASSERT_FALSE(strip.empty());
        if (longest > 0) {
          ASSERT_LE(strip.size(), std::size_t(longest));
        }
        for (std::size_t i = 1; i < strip.size(); i++) {
          const auto& neighbours = graph.neighbours(strip[i - 1]);
          ASSERT_NE(std::find(neighbours.begin(), neighbours.end(), strip[i]), neighbours.end());
        }
      }
    }
  }
}

TEST(TeTriangleStrips, DecodeToTheSameTrianglesWithTheSameWinding) {
  for (const Indices& indices : {gridOf(1).indices, gridOf(9).indices, irregularMesh(64, 1).indices,
                                 icosahedron(), Indices{4, 2, 7}, Indices()}) {
    const TeTriangleStrips strips = TeTriangleStrips::create(indices);
    EXPECT_EQ(sortedTriangles(TeTriangleStrips::decode(strips.encodeAll(indices))), sortedTriangles(indices));
    Indices each;
    for (const std::vector<std::int32_t>& strip : strips.strips()) {
      const Indices decoded = TeTriangleStrips::decode(TeTriangleStrips::encode(strip, indices));
      each.insert(each.end(), decoded.begin(), decoded.end());
    }
    EXPECT_EQ(sortedTriangles(each), sortedTriangles(indices));
  }
}

// Document 003: (v0, v1, v2, v3, swap, v4, v5, v6) is sent as (v0, v1, v2, v3, v2, v4, v5, v6).
TEST(TeTriangleStrips, SwapsRepeatAVertex) {
  const Indices fan{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5, 4, 5, 6};
  EXPECT_EQ(TeTriangleStrips::encode({0, 1, 2, 3, 4}, fan), (Indices{0, 1, 2, 3, 4, 5, 6}));
  const Indices turning{0, 1, 2, 2, 1, 3, 2, 3, 4, 2, 4, 5};
  const Indices encoded = TeTriangleStrips::encode({0, 1, 2, 3}, turning);
  EXPECT_EQ(encoded, (Indices{0, 1, 2, 3, 2, 4, 5}));
  EXPECT_EQ(sortedTriangles(TeTriangleStrips::decode(encoded)), sortedTriangles(turning));
}

// A row of a grid has one strip of alternating turns: 1 + 2/m vertices a triangle.
TEST(TeTriangleStrips, AreLongOnGrids) {
  const TeLodMesh grid = gridOf(64);
  const TeTriangleStrips strips = TeTriangleStrips::create(grid.indices);
  EXPECT_LE(strips.strips().size(), 70U);
  const double perTriangle = double(strips.encodeAll(grid.indices).size()) / double(grid.triangles());
  EXPECT_LT(perTriangle, 1.06);
  EXPECT_GE(perTriangle, 1);
  const TeLodMesh irregular = irregularMesh(128, 2);
  const TeTriangleStrips others = TeTriangleStrips::create(irregular.indices);
  std::printf("grid: %.3f vertices a triangle, %zu strips; irregular: %.3f, %zu strips of %lld triangles\n",
              perTriangle, strips.strips().size(),
              double(others.encodeAll(irregular.indices).size()) / double(irregular.triangles()),
              others.strips().size(), static_cast<long long>(irregular.triangles()));
}
