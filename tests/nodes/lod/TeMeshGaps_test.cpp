#include "nodes/lod/TeMeshGaps.h"

#include <gtest/gtest.h>

namespace {

/// 17² samples, 10 m apart, all of height 100 units of half a metre.
TeLodFieldPtr plain() {
  TeHeightMap heights = TeHeightMap::create(17, 17).value();
  EXPECT_TRUE(heights.fill(100, heights.bounds()));
  TeLodField::Placement placement;
  placement.spacing = 10;
  placement.heightScale = 0.5;
  return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(heights)), placement).value();
}

/// Columns west to east - 1, two triangles a square of `step` cells with vertices of its own.
void addGrid(TeLodMesh& mesh, int west, int east, int step, float height = 100) {
  for (int row = 0; row < 16; row += step)
    for (int column = west; column < east; column += step) {
      const auto first = std::uint32_t(mesh.vertices.size());
      mesh.vertices.push_back({column, row, height});
      mesh.vertices.push_back({column + step, row, height});
      mesh.vertices.push_back({column + step, row + step, height});
      mesh.vertices.push_back({column, row + step, height});
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
}

/// Walls in steps of `step` rows along a column.
void addWall(TeLodMesh& mesh, int column, int step, float top, float bottom) {
  for (int row = 0; row < 16; row += step) {
    const auto first = std::uint32_t(mesh.vertices.size());
    mesh.vertices.push_back({column, row, top});
    mesh.vertices.push_back({column, row + step, top});
    mesh.vertices.push_back({column, row + step, bottom});
    mesh.vertices.push_back({column, row, bottom});
    mesh.skirts.insert(mesh.skirts.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
}

std::int64_t gapsOf(const TeLodMesh& mesh, const TeLodView& view = TeLodView()) {
  return TeMeshGaps(plain()).count(mesh, view);
}

} // namespace

TEST(TeMeshGaps, ThereAreNoneWhereEdgesAreSharedBySampleAndHeight) {
  TeLodMesh mesh;
  addGrid(mesh, 0, 16, 4);
  EXPECT_EQ(gapsOf(mesh), 0);

  TeLodMesh holed = mesh;
  holed.indices.erase(holed.indices.begin() + 30, holed.indices.begin() + 33);
  EXPECT_EQ(gapsOf(holed), 3);

  TeLodMesh lifted = mesh;
  const auto& corner = lifted.vertices[lifted.indices[30]];
  lifted.vertices.push_back({corner.column, corner.row, 101});
  lifted.indices[30] = std::uint32_t(lifted.vertices.size() - 1);
  EXPECT_EQ(gapsOf(lifted), 4) << "two of its edges no longer meet the neighbours'";

  TeLodMesh twice = mesh;
  twice.indices.insert(twice.indices.end(), mesh.indices.begin() + 30, mesh.indices.begin() + 33);
  EXPECT_EQ(gapsOf(twice), 3) << "of three triangles";
  EXPECT_EQ(gapsOf(TeLodMesh()), 0);
}

TEST(TeMeshGaps, FindsTJunctions) {
  TeLodMesh mesh;
  addGrid(mesh, 0, 8, 4);
  addGrid(mesh, 8, 16, 8);
  EXPECT_EQ(gapsOf(mesh), 4 + 2);
}

TEST(TeMeshGaps, WhatIsOutOfViewDoesNotCount) {
  TeLodMesh mesh;
  addGrid(mesh, 0, 8, 4);
  addGrid(mesh, 8, 16, 8);
  TeLodView view;
  view.planeCount = 1;
  view.planes[0] = {0, 0, 1, -1000};
  EXPECT_EQ(gapsOf(mesh, view), 0);
  view.planes[0] = {0, 1, 0, -85}; // the northern half
  EXPECT_EQ(gapsOf(mesh, view), 2 + 1);
  view.planes[0] = {-1, 0, 0, 79.9}; // ends just west of it
  EXPECT_EQ(gapsOf(mesh, view), 0);
}

TEST(TeMeshGaps, SkirtsHideWhatTheyReach) {
  TeLodMesh mesh;
  addGrid(mesh, 0, 8, 4, 110);
  addGrid(mesh, 8, 16, 8, 100);
  ASSERT_EQ(gapsOf(mesh), 6);

  TeLodMesh hidden = mesh;
  addWall(hidden, 8, 4, 110, 95);
  addWall(hidden, 8, 8, 100, 90);
  EXPECT_EQ(gapsOf(hidden), 0);

  TeLodMesh shallow = mesh;
  addWall(shallow, 8, 4, 110, 101);
  addWall(shallow, 8, 8, 100, 90);
  EXPECT_EQ(gapsOf(shallow), 4) << "the higher side's walls end above the other";

  TeLodMesh oneSided = mesh;
  addWall(oneSided, 8, 8, 100, 90);
  EXPECT_EQ(gapsOf(oneSided), 4);

  TeLodMesh torn = hidden;
  torn.skirts.erase(torn.skirts.begin() + 3, torn.skirts.begin() + 6);
  EXPECT_EQ(gapsOf(torn), 1) << "half of a wall of the higher side is missing";

  TeLodMesh elsewhere = mesh;
  addWall(elsewhere, 4, 4, 110, 50);
  EXPECT_EQ(gapsOf(elsewhere), 4);

  TeLodMesh holed = hidden;
  holed.indices.erase(holed.indices.begin() + 24, holed.indices.begin() + 27);
  EXPECT_EQ(gapsOf(holed), 3) << "there is nothing beside its edges";

  TeLodMesh level;
  addGrid(level, 0, 8, 4);
  addGrid(level, 8, 16, 8);
  addWall(level, 4, 4, 100, 50);
  EXPECT_EQ(gapsOf(level), 0) << "the surfaces lie on each other";
}
