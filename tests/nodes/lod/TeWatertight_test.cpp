#include "nodes/lod/TeWatertight.h"

#include <gtest/gtest.h>

namespace {

std::uint32_t at(std::uint32_t column, std::uint32_t row) { return row * 3 + column; }

/// Four cells, each two triangles.
void addSquare(TeWatertight& mesh) {
  for (std::uint32_t y = 0; y < 2; y++)
    for (std::uint32_t x = 0; x < 2; x++) {
      mesh.add(at(x, y), at(x + 1, y), at(x + 1, y + 1));
      mesh.add(at(x, y), at(x + 1, y + 1), at(x, y + 1));
    }
}

} // namespace

TEST(TeWatertight, acceptsAMeshThatCoversItsSquare) {
  TeWatertight mesh(2);
  addSquare(mesh);
  EXPECT_EQ(mesh.cracks(), 0);
  EXPECT_EQ(mesh.slivers(), 0);
  EXPECT_TRUE(mesh.coversSquare());
}

TEST(TeWatertight, findsAMissingTriangle) {
  TeWatertight mesh(2);
  mesh.add(at(0, 0), at(2, 0), at(2, 2));
  EXPECT_EQ(mesh.cracks(), 1);
  EXPECT_FALSE(mesh.coversSquare());
}

TEST(TeWatertight, findsATJunction) {
  TeWatertight mesh(2);
  mesh.add(at(0, 0), at(2, 0), at(2, 2));
  mesh.add(at(0, 0), at(1, 1), at(0, 2));
  mesh.add(at(1, 1), at(2, 2), at(0, 2));
  EXPECT_TRUE(mesh.coversSquare());
  EXPECT_EQ(mesh.cracks(), 3);
}

TEST(TeWatertight, findsOverlaps) {
  TeWatertight mesh(2);
  addSquare(mesh);
  mesh.add(at(0, 0), at(1, 0), at(1, 1));
  EXPECT_GT(mesh.cracks(), 0);
  EXPECT_FALSE(mesh.coversSquare());
}

TEST(TeWatertight, countsTrianglesWithoutArea) {
  TeWatertight mesh(2);
  mesh.add(at(0, 0), at(1, 1), at(2, 2));
  mesh.add(at(0, 0), at(0, 2), at(2, 2));
  EXPECT_EQ(mesh.slivers(), 2);
  mesh.clear();
  EXPECT_EQ(mesh.slivers(), 0);
  EXPECT_EQ(mesh.doubleArea(), 0);
}
