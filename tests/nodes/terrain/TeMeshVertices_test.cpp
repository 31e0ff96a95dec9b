#include "nodes/terrain/TeMeshVertices.h"

#include "nodes/gridMesh.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>

namespace {

TeLattice lattice(int samples, double spacing) { return *TeLattice::create(samples, spacing); }

float slope(double x, double y) { return float(0.25 * x - 0.5 * y); }

using Triangle = std::array<std::size_t, 3>;

std::vector<Triangle> trianglesOf(const TePatchMesh& mesh) {
  std::vector<Triangle> triangles;
  teForEachTriangle(mesh, [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.push_back({a, b, c});
  });
  return triangles;
}

} // namespace

TEST(TeMeshVertices, TrianglesCoverTheGridCounterClockwise) {
  const TePatchMesh mesh = gridMesh(lattice(65, 1), -3, 5, 5, 4, slope);
  const std::vector<Triangle> triangles = trianglesOf(mesh);
  ASSERT_EQ(triangles.size(), 2u * 4 * 3);
  EXPECT_EQ(teTriangleCount(mesh), 2 * 4 * 3);
  EXPECT_TRUE(teIsWholeGrid(mesh));
  std::set<std::set<std::size_t>> different;
  for (const auto& [a, b, c] : triangles) {
    const glm::vec3 normal =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    EXPECT_FLOAT_EQ(normal.z, 1); // twice half a cell
    different.insert({a, b, c});
  }
  EXPECT_EQ(different.size(), triangles.size());
}

TEST(TeMeshVertices, StripsWithGapsAreNotAWholeGrid) {
  TePatchMesh mesh = gridMesh(lattice(65, 1), 0, 0, 4, 3, slope);
  // The middle cell of the lower row is left out.
  mesh.strips = {4, 0, 5, 1, -1, 6, 2, 7, 3, -1, 8, 4, 9, 5, 10, 6, 11, 7, -1};
  EXPECT_EQ(teTriangleCount(mesh), 2 * 5);
  EXPECT_EQ(trianglesOf(mesh).size(), 2u * 5);
  EXPECT_FALSE(teIsWholeGrid(mesh));
  EXPECT_FALSE(teIsWholeGrid(TePatchMesh()));
}

TEST(TeMeshVertices, SharedVerticesAreTheSameBits) {
  for (const double spacing : {0.1, 1.0, 0.3333333, 92.7}) {
    for (const std::int64_t first : {std::int64_t(0), std::int64_t(-977), std::int64_t(1) << 40}) {
      const TeLattice grid = lattice(65, spacing);
      const glm::dvec2 anchor(grid.position(first + 20) + 0.123, grid.position(7));
      const auto left = teMeshPositions(gridMesh(grid, first, 0, 31, 31, slope), anchor);
      const auto right = teMeshPositions(gridMesh(grid, first + 30, 0, 3, 31, slope), anchor);
      for (std::size_t row = 0; row < 31; row++)
        ASSERT_EQ(std::memcmp(&left[row * 31 + 30], &right[row * 3], 2 * sizeof(float)), 0);
    }
  }
}

TEST(TeMeshVertices, NormalsAreWithinTwoHundredThousandths) {
  TePatchMesh mesh = gridMesh(lattice(65, 1), 0, 0, 2, 2, slope);
  const glm::vec3 normals[] = {
      {0, 0, 1}, {-1, 0, 0}, {0.6f, -0.8f, 0}, glm::normalize(glm::vec3(0.123f, -0.456f, 0.789f))};
  mesh.normals.assign(std::begin(normals), std::end(normals));
  const auto attributes = teMeshAttributes(mesh, {0x11223344, 0xFF000080, 0, 0xFFFFFFFF});
  for (std::size_t i = 0; i < 4; i++) {
    for (int axis = 0; axis < 3; axis++)
      EXPECT_NEAR(float(attributes[i].normal[axis]) / 32767, normals[i][axis], 2e-5f);
  }
  EXPECT_EQ(attributes[0].colour[0], 0x11);
  EXPECT_EQ(attributes[0].colour[1], 0x22);
  EXPECT_EQ(attributes[0].colour[2], 0x33);
  EXPECT_EQ(attributes[0].colour[3], 0x44);
  EXPECT_EQ(teMeshAttributes(mesh, {})[2].colour[1], 0xFF);
}
