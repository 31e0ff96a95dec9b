#include "patchdb/TePatchMesh.h"

#include "patchdb/TeMeshBuilder.h"
#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeSurfaceNormals.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TePatchMesh, ThePartsHaveTheSizesOfTheDocument) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 65);
  for (int y = 0; y <= 1; ++y)
    for (int x = 0; x <= 1; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  const TePatchData& patch = *database->find({0, 0, 0});
  const TePatchMesh inside = *database->patchMesh(patch); // 32 cells, of which 30 are drawn
  EXPECT_EQ(inside.columns, 31);
  EXPECT_EQ(inside.rows, 31);
  EXPECT_EQ(inside.part, TeSurfacePart::Patch);
  const TePatchMesh east = *database->seamMesh(patch, TeDirection::East);
  EXPECT_EQ(east.columns, 3);
  EXPECT_EQ(east.rows, 31);
  EXPECT_EQ(east.part, TeSurfacePart::Seam);
  const TePatchMesh north = *database->seamMesh(patch, TeDirection::North);
  EXPECT_EQ(north.columns, 31);
  EXPECT_EQ(north.rows, 3);
  const TePatchMesh corner = *database->seamMesh(patch, TeDirection::NorthEast);
  EXPECT_EQ(corner.columns * corner.rows, 9);
  EXPECT_EQ(corner.part, TeSurfacePart::Corner);
  EXPECT_EQ(corner.origin, glm::dvec3(16, 16, 0));
  EXPECT_EQ(inside.origin, glm::dvec3(0, 0, 0));
}

TEST(TePatchMesh, VerticesLieAtTheSamplesWithTheirFloats) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17, 30.0);
  ASSERT_TRUE(database->build({-5, 1000000007, 0}));
  const TePatchData& patch = *database->find({-5, 1000000007, 0});
  const TePatchMesh mesh = *database->patchMesh(patch);
  for (int y = 0; y < mesh.rows; ++y)
    for (int x = 0; x < mesh.columns; ++x) {
      const glm::vec3 local = mesh.positions[std::size_t(y * mesh.columns + x)];
      EXPECT_EQ(local.z, patch.heights().at(x + 1, y + 1));
      EXPECT_EQ(mesh.origin.x + local.x, database->lattice().position(-5 * 8 + 1 + x));
      EXPECT_EQ(mesh.origin.y + local.y, database->lattice().position(1000000007ll * 8 + 1 + y));
    }
}

TEST(TePatchMesh, CoordinatesMoveByLessThanAFloatCanTell) {
  for (double spacing : {0.1, 27.3, 1.0 / 3, 9.9999}) {
    const TeLattice lattice = *TeLattice::create(65, spacing);
    for (std::int64_t sample : {0ll, 5ll, -17ll, 123456789ll}) {
      const double exact = lattice.position(sample);
      EXPECT_LE(std::fabs(teMeshCoordinate(lattice, 0, exact) - exact), lattice.patchSide() * 0x1p-24);
    }
  }
  for (double spacing : {1.0, 0.5, 10.0, 30.0, 90.0}) {
    const TeLattice lattice = *TeLattice::create(65, spacing);
    for (std::int64_t sample = -100; sample < 100; ++sample)
      EXPECT_EQ(teMeshCoordinate(lattice, 0, lattice.position(sample)), lattice.position(sample));
  }
}

TEST(TePatchMesh, TheSmallestMapsHaveCornerSquaresOnly) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 5);
  for (int y = 0; y <= 1; ++y)
    for (int x = 0; x <= 1; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  const TePatchData& patch = *database->find({0, 0, 0});
  for (const TePatchMesh& mesh :
       {*database->patchMesh(patch), *database->seamMesh(patch, TeDirection::East)}) {
    EXPECT_EQ(mesh.columns, 0);
    EXPECT_EQ(mesh.bytes(), 0u);
  }
  EXPECT_EQ(database->seamMesh(patch, TeDirection::NorthEast)->positions.size(), 9u);
}

TEST(TePatchMesh, HolesLeaveOutTheirCellsAndNoNaN) {
  // Holes inside a patch, on a border, at a corner, and a whole patch.
  auto database = teSampleWorld(
      [](std::int64_t x, std::int64_t y) {
        const bool hole =
            (x == 3 && y == 4) || (x == 8 && y == 3) || (x == 8 && y == 8) || (x < -2 && y < -2);
        return hole ? TeHeightMap::missing() : float(x - y);
      },
      17);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  TeMeshCensus census;
  for (const TePatchMesh& mesh : teBlockMeshes(*database, {-1, -1, 0}, 3, 3)) {
    EXPECT_TRUE(census.add(mesh));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(std::isfinite(mesh.positions[v][axis]));
        ASSERT_TRUE(std::isfinite(mesh.normals[v][axis]));
      }
  }
  // 22×22 cells are drawn in full: three single holes take four each, the patch its 4×4 with one around.
  EXPECT_EQ(census.triangles().size(), 2u * (22 * 22 - 3 * 4 - 5 * 5));
  EXPECT_EQ(census.brokenEdges(), 0);
}

TEST(TePatchMesh, CoarseLevelsTileLikeTheBase) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17, 0.7);
  TeHeightMap heights = *TeHeightMap::create(9, 9);
  for (int y = -1; y <= 0; ++y)
    for (int x = -1; x <= 0; ++x)
      (*database->lookup({x, y, 3}, TeLookup::Create))->setHeights(heights, 1.0f);
  TeMeshCensus census;
  double area = 0;
  for (const TePatchMesh& mesh : teBlockMeshes(*database, {-1, -1, 3}, 2, 2))
    EXPECT_TRUE(census.add(mesh));
  for (const TeMeshCensus::Triangle& triangle : census.triangles())
    area += triangle.areaInPlan();
  EXPECT_EQ(census.triangles().size(), 2u * 14 * 14);
  EXPECT_NEAR(area, std::pow(14 * 8 * 0.7, 2), 1e-3);
  EXPECT_EQ(census.brokenEdges(), 0);
}
