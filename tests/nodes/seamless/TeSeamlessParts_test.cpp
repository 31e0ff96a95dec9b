#include "nodes/seamless/TeSeamlessParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace {

TeSeamlessParts parts(int minResolution, int levels) {
  return TeSeamlessParts(TeSeamlessLayout::create(4096, minResolution, levels).value());
}

int largestIndex(const TeSeamlessParts& all, const TePart& part) {
  return *std::max_element(all.indices().begin() + part.firstIndex,
                           all.indices().begin() + part.firstIndex + part.count);
}

} // namespace

// Document 004, figures and tables 5.1 and 5.2: resolutions 4 and 8.
TEST(TeSeamlessParts, haveTheDocumentsLayout) {
  const TeSeamlessParts all = parts(4, 2);
  EXPECT_EQ(all.vertices().size(), 132u);
  EXPECT_EQ(all.indices().size(), 192u);
  const auto check = [](const TePart& part, int vertex, int index, int end) {
    EXPECT_EQ(part.firstVertex, vertex);
    EXPECT_EQ(part.firstIndex, index);
    EXPECT_EQ(part.firstIndex + part.count, end);
  };
  check(all.tile(TeNorth, 1), 0, 0, 54);
  check(all.strip(TeNorth, 1, 0), 64, 102, 138);
  check(all.tile(TeEast, 0), 16, 54, 60);
  check(all.strip(TeEast, 0, 0), 81, 174, 192);
  check(all.tile(TeSouth, 0), 32, 54, 60);
  check(all.strip(TeSouth, 0, 1), 98, 138, 174);
  check(all.tile(TeWest, 1), 48, 0, 54);
  check(all.strip(TeWest, 1, 1), 115, 60, 102);
}

TEST(TeSeamlessParts, topTileHasTheDocumentsVertices) {
  const TeSeamlessParts all = parts(4, 2);
  // Rows of 7, 5, 3 and 1 vertices from the outside to the inside.
  EXPECT_EQ(all.vertices()[0].x, 1);
  EXPECT_EQ(all.vertices()[0].y, 8);
  EXPECT_EQ(all.vertices()[6].x, 7);
  EXPECT_EQ(all.vertices()[7].x, 2);
  EXPECT_EQ(all.vertices()[7].y, 7);
  EXPECT_EQ(all.vertices()[15].x, 4);
  EXPECT_EQ(all.vertices()[15].y, 5);
  // The eastern tile is the same, turned.
  EXPECT_EQ(all.vertices()[16].x, 8);
  EXPECT_EQ(all.vertices()[16].y, 7);
}

TEST(TeSeamlessParts, sixteenBitsNumberAPatchOf512) {
  const TeSeamlessParts all = parts(128, 3);
  EXPECT_EQ(largestIndex(all, all.tile(TeNorth, 2)), 65535);
  EXPECT_EQ(all.tile(TeEast, 2).firstVertex, 65536);
}

TEST(TeSeamlessParts, reachTheirOwnVerticesOnly) {
  for (const int levels : {2, 3, 4}) {
    const TeSeamlessParts all = parts(4, levels);
    const int tileVertices = all.tile(TeEast, 0).firstVertex;
    const int stripVertices = all.strip(TeEast, 0, 0).firstVertex - all.strip(TeNorth, 0, 0).firstVertex;
    for (int a = 0; a < levels; a++) {
      EXPECT_LT(largestIndex(all, all.tile(TeNorth, a)), tileVertices);
      for (int b = 0; b < levels; b++)
        EXPECT_LT(largestIndex(all, all.strip(TeNorth, a, b)), stripVertices);
    }
  }
}

// A tile's vertices follow its own side, a strip's those of the tiles beside it, its diagonal the finer one.
TEST(TeSeamlessParts, vertexChainsLieWhereTilesMeetStrips) {
  const TeSeamlessParts all = parts(4, 2);
  const TePart strip = all.strip(TeNorth, 1, 1);
  std::set<std::pair<int, int>> tile;
  for (int i = 0; i < 16; i++)
    tile.insert({all.vertices()[std::size_t(i)].x, all.vertices()[std::size_t(i)].y});
  for (int i = strip.firstIndex; i < strip.firstIndex + strip.count; i++) {
    const TePartVertex& vertex =
        all.vertices()[std::size_t(strip.firstVertex) + all.indices()[std::size_t(i)]];
    if (vertex.chain == TePartVertex::kDiagonal + TeNorth)
      EXPECT_EQ(vertex.x, vertex.y);
    else
      EXPECT_EQ(tile.count({vertex.x, vertex.y}), vertex.chain == TeNorth ? 1u : 0u);
  }
}

// Each whole patch has the triangles and chains of its tiles and strips.
TEST(TeSeamlessParts, wholePatchesAreTheirPartsTogether) {
  const TeSeamlessLayout layout = TeSeamlessLayout::create(1024, 4, 3).value();
  const TeSeamlessParts all(layout, true);
  ASSERT_TRUE(all.hasWholePatches());
  using Corner = std::array<int, 3>; // x, y, chain
  const auto trianglesOf = [&](const TePart& part, std::multiset<std::array<Corner, 3>>& triangles) {
    std::array<Corner, 3> triangle;
    for (int i = 0; i < part.count; i++) {
      const TePartVertex& vertex =
          all.vertices()[std::size_t(part.firstVertex) + all.indices()[std::size_t(part.firstIndex + i)]];
      // The centre of the patch and its corners belong to several strips, and never move.
      const bool still = vertex.x % 4 == 0 && vertex.y % 4 == 0;
      triangle[std::size_t(i % 3)] = {vertex.x, vertex.y, still ? -1 : vertex.chain};
      if (i % 3 == 2)
        triangles.insert(triangle);
    }
  };
  for (std::uint8_t n = 0; n < 3; n++)
    for (std::uint8_t e = 0; e < 3; e++)
      for (std::uint8_t w = 0; w < 3; w++) {
        std::multiset<std::array<Corner, 3>> whole, parts;
        trianglesOf(all.patch({n, e, 1, w}), whole);
        for (int side = 0; side < 4; side++) {
          const int indices[] = {n, e, 1, w};
          trianglesOf(all.tile(side, indices[side]), parts);
          trianglesOf(all.strip(side, indices[side], indices[(side + 1) % 4]), parts);
        }
        EXPECT_EQ(whole, parts);
      }
}

TEST(TeSeamlessParts, wholePatchesAreMadeWhereTheyFit) {
  const auto fits = [](int minResolution, int levels) {
    return TeSeamlessParts::fitsWholePatches(TeSeamlessLayout::create(4096, minResolution, levels).value());
  };
  EXPECT_TRUE(fits(16, 3));
  EXPECT_TRUE(fits(2, 2));
  EXPECT_FALSE(fits(64, 3)) << "more vertices than 16 bits number";
  EXPECT_FALSE(fits(2, 7)) << "too many combinations";
  EXPECT_FALSE(parts(16, 3).hasWholePatches()) << "only on request";
}
