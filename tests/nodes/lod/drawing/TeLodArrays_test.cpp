#include "nodes/lod/drawing/TeLodArrays.h"

#include "nodes/lod/brute/TeBruteForce.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

TeLodFieldPtr waves(int cells, double spacing = 2, double heightScale = 0.5) {
  TeHeightMap map = std::move(TeHeightMap::create(cells + 1, cells + 1).value());
  for (int y = 0; y <= cells; y++)
    for (int x = 0; x <= cells; x++)
      map.at(x, y) = float(20 * std::sin(0.3 * x) * std::cos(0.2 * y + 1));
  TeLodField::Placement placement;
  placement.spacing = spacing;
  placement.heightScale = heightScale;
  placement.corner = {1e6, -2e6, 30};
  return *TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), placement);
}

TeLodMesh wholeMesh(TeLodFieldPtr field) {
  TeBruteForce method(std::move(field));
  TeLodView view;
  method.select(view, TeLodAccuracy());
  TeLodMesh mesh;
  method.appendMesh(mesh);
  return mesh;
}

} // namespace

TEST(TeLodArrays, PositionsAreMetresFromTheAnchor) {
  const TeLodFieldPtr field = waves(8);
  const glm::dvec3 anchor = field->position(3, 4, 0);
  TeLodMesh mesh;
  mesh.vertices = {field->vertex(3, 4), field->vertex(5, 4), {5, 4, -100}};
  mesh.indices = {0, 1, 2};
  TeLodArrays arrays;
  TeLodArrayMaker(*field, anchor, nullptr).make(mesh, arrays);
  ASSERT_EQ(arrays.vertices.size(), 3u);
  EXPECT_EQ(arrays.vertices[0].position[0], 0);
  EXPECT_EQ(arrays.vertices[1].position[0], 4);
  EXPECT_EQ(arrays.vertices[1].position[1], 0);
  EXPECT_FLOAT_EQ(arrays.vertices[1].position[2], 0.5f * field->height(5, 4));
  EXPECT_EQ(arrays.vertices[2].position[2], -50);
  // The normal is that of the sample, wherever the vertex has been moved to.
  EXPECT_EQ(std::memcmp(arrays.vertices[1].normal, arrays.vertices[2].normal, 6), 0);
  EXPECT_EQ(arrays.triangles(), 1);
}

TEST(TeLodArrays, NormalsAreThoseOfAllSamples) {
  const TeLodFieldPtr field = waves(16);
  const TeLodArrayMaker maker(*field, glm::dvec3(0), nullptr);
  for (int y = 0; y <= 16; y++)
    for (int x = 0; x <= 16; x++) {
      const glm::vec3 normal = maker.normal(field->vertex(x, y));
      EXPECT_NEAR(glm::length(normal), 1, 1e-6);
      if (x == 0 || y == 0 || x == 16 || y == 16)
        continue;
      const glm::dvec3 east =
          field->position(field->vertex(x + 1, y)) - field->position(field->vertex(x - 1, y));
      const glm::dvec3 north =
          field->position(field->vertex(x, y + 1)) - field->position(field->vertex(x, y - 1));
      EXPECT_NEAR(glm::length(glm::dvec3(normal) - glm::normalize(glm::cross(east, north))), 0, 1e-6);
    }
  const TeLodFieldPtr flat = waves(4, 2, 0);
  EXPECT_EQ(TeLodArrayMaker(*flat, glm::dvec3(0), nullptr).normal(flat->vertex(2, 2)), glm::vec3(0, 0, 1));
}

TEST(TeLodArrays, SmallPartsHaveSmallIndices) {
  TeLodArrays arrays;
  for (const int cells : {32, 256}) {
    const TeLodFieldPtr field = waves(cells);
    const TeLodMesh mesh = wholeMesh(field);
    TeLodArrayMaker(*field, glm::dvec3(0), nullptr).make(mesh, arrays);
    EXPECT_EQ(arrays.shortIndices.empty(), mesh.vertices.size() > 65535);
    EXPECT_EQ(arrays.triangles(), 2 * cells * cells);
    EXPECT_EQ(arrays.bytes(), 24 * mesh.vertices.size() + (cells == 32 ? 2u : 4u) * mesh.indices.size());
    TeLodArrays expanded = arrays;
    TeLodArrayMaker::expand(expanded);
    EXPECT_EQ(expanded.triangles(), arrays.triangles());
    EXPECT_EQ(expanded.indexBytes(), 0u);
    for (std::size_t i = 0; i < mesh.indices.size(); i++)
      ASSERT_EQ(std::memcmp(&expanded.vertices[i], &arrays.vertices[mesh.indices[i]], sizeof(TeDrawnVertex)),
                0);
  }
}

TEST(TeLodArrays, SkirtsAreDrawnToo) {
  const TeLodFieldPtr field = waves(8);
  TeLodMesh mesh;
  mesh.vertices = {field->vertex(0, 0), field->vertex(8, 0), field->vertex(0, 8), {0, 0, -99}};
  mesh.indices = {0, 1, 2};
  mesh.skirts = {3, 1, 0};
  TeLodArrays arrays;
  TeLodArrayMaker(*field, glm::dvec3(0), nullptr).make(mesh, arrays);
  EXPECT_EQ(arrays.shortIndices, (std::vector<std::uint16_t>{0, 1, 2, 3, 1, 0}));
}

TEST(TeLodArrays, ColoursAreByHeightAndSlope) {
  const TeLodFieldPtr field = waves(32);
  const auto colours = TeSeamlessSlopeColours::forHeights(-10, 10);
  const TeLodArrayMaker maker(*field, glm::dvec3(0), &colours);
  for (int x = 0; x <= 32; x++) {
    const TeLodVertex vertex = field->vertex(x, 7);
    const glm::vec3 normal = maker.normal(vertex);
    const float slope = std::hypot(normal.x, normal.y) / normal.z;
    EXPECT_LT(glm::length(maker.colour(vertex, normal) - colours.colour(0.5f * vertex.height, slope)), 1e-4f);
  }
  EXPECT_EQ(TeLodArrayMaker(*field, glm::dvec3(0), nullptr).colour(field->vertex(1, 1), {0, 0, 1}),
            glm::vec3(1));
}
