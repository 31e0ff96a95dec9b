#include "nodes/seamless/TeSeamlessMesh.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

namespace {

TeHeightMap roughMap(int side) {
  TeHeightMap map = TeHeightMap::create(side, side).value();
  std::mt19937 random(7);
  for (int y = 0; y < side; y++)
    for (int x = 0; x < side; x++)
      map.at(x, y) = float(random() % 1000);
  return map;
}

std::vector<TeSeamlessMesh::Triangle> trianglesOf(const TeSeamlessPatch& patch,
                                                  const TeSeamlessLayout& layout, const TeHeightMap& map) {
  std::vector<TeSeamlessMesh::Triangle> triangles;
  TeSeamlessMesh::appendPatch(patch, layout, TeSeamlessParts(layout), TeSeamlessMapHeights(&map), triangles);
  return triangles;
}

/// Height of a mesh at every sample; corners of triangles agree where they meet.
std::vector<float> surfaceOf(const std::vector<TeSeamlessMesh::Triangle>& triangles, int side) {
  std::vector<float> surface(std::size_t(side) * std::size_t(side), -1);
  for (const TeSeamlessMesh::Triangle& t : triangles) {
    const double area = double(t.b.column - t.a.column) * (t.c.row - t.a.row) -
                        double(t.c.column - t.a.column) * (t.b.row - t.a.row);
    for (int y = 0; y < side; y++)
      for (int x = 0; x < side; x++) {
        const double b =
            (double(x - t.a.column) * (t.c.row - t.a.row) - double(t.c.column - t.a.column) * (y - t.a.row)) /
            area;
        const double c =
            (double(t.b.column - t.a.column) * (y - t.a.row) - double(x - t.a.column) * (t.b.row - t.a.row)) /
            area;
        if (b < 0 || c < 0 || b + c > 1)
          continue;
        const float height = float(t.a.height * (1 - b - c) + t.b.height * b + t.c.height * c);
        float& stored = surface[std::size_t(y) * std::size_t(side) + std::size_t(x)];
        if (stored >= 0) {
          EXPECT_NEAR(stored, height, 1e-3);
        }
        stored = height;
      }
  }
  return surface;
}

} // namespace

TEST(TeSeamlessMesh, hasAllSamplesAtFullResolution) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(16, 4, 3).value();
  const TeHeightMap map = roughMap(17);
  TeSeamlessPatch patch;
  patch.detail = {2, 2, 2, 2};
  const auto surface = surfaceOf(trianglesOf(patch, layout, map), 17);
  for (int y = 0; y < 17; y++)
    for (int x = 0; x < 17; x++)
      EXPECT_EQ(surface[std::size_t(y * 17 + x)], map.at(x, y));
}

// Weight 0 of a resolution is the surface of the next lower one: nothing jumps when a level changes.
TEST(TeSeamlessMesh, morphsFromTheLowerResolution) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(16, 4, 3).value();
  const TeHeightMap map = roughMap(17);
  for (const float lower : {0.0f, 1.0f}) {
    TeSeamlessPatch coarse, fine;
    coarse.detail = {lower, lower, lower, lower};
    fine.detail.fill(std::nextafter(lower, 2.0f));
    ASSERT_EQ(fine.resolution(0), int(lower) + 1);
    const auto before = surfaceOf(trianglesOf(coarse, layout, map), 17);
    const auto after = surfaceOf(trianglesOf(fine, layout, map), 17);
    for (std::size_t i = 0; i < before.size(); i++)
      EXPECT_NEAR(before[i], after[i], 1e-3);
  }
}

TEST(TeSeamlessMesh, halfWeightIsHalfWay) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(4, 2, 2).value();
  TeHeightMap map = TeHeightMap::create(5, 5).value();
  map.at(1, 4) = 100;
  TeSeamlessPatch patch;
  patch.detail = {0.5f, 0, 0, 0};
  for (const TeSeamlessMesh::Triangle& triangle : trianglesOf(patch, layout, map))
    for (const TeSeamlessMesh::Vertex& vertex : {triangle.a, triangle.b, triangle.c})
      if (vertex.column == 1 && vertex.row == 4) {
        EXPECT_NEAR(vertex.height, 50, 0.5);
      }
}
