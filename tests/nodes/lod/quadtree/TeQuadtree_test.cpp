#include "nodes/lod/quadtree/TeQuadtree.h"

#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/TeWatertight.h"
#include "nodes/lod/quadtree/TeQuadtreeMesh.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using Sides = TeQuadtreeSides;

constexpr double kStep = 1 + 1.0 / 256; ///< of numbers in 16 bits

TeHeightMap roughMap(int cells, unsigned seed) {
  std::mt19937 random(seed);
  return stressMap(StressField::Rough, cells, random);
}

/// All vertices that the tree has, and their heights.
std::map<std::pair<int, int>, float> heightsOf(const TeQuadtree& tree) {
  std::map<std::pair<int, int>, float> heights;
  for (int row = 0; row <= tree.side(); row++)
    for (int column = 0; column <= tree.side(); column++)
      if (const std::optional<float> height = tree.height(column, row))
        heights[{column, row}] = *height;
  return heights;
}

/// Sees everything exactly, and tells what is wrong with the triangles.
void expectFits(const TeQuadtree& tree, const TeLodView& view, double pixelError) {
  TeQuadtreeMesh mesh(tree, {});
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = pixelError;
  mesh.update(view, wish);
  EXPECT_EQ(mesh.inconsistency(), "");
  TeLodMesh drawn;
  mesh.append(drawn);
  TeWatertight watertight(tree.side());
  for (std::size_t i = 0; i < drawn.indices.size(); i += 3) {
    const auto number = [&](std::size_t corner) {
      const TeLodVertex& vertex = drawn.vertices[drawn.indices[i + corner]];
      EXPECT_EQ(vertex.height, tree.height(vertex.column, vertex.row));
      return std::uint32_t(vertex.row * (tree.side() + 1) + vertex.column);
    };
    watertight.add(number(0), number(1), number(2));
  }
  EXPECT_EQ(watertight.cracks(), 0);
  EXPECT_TRUE(watertight.coversSquare());
}

} // namespace

TEST(TeQuadtree, HasAllSamplesOfADenseMap) {
  const TeHeightMap map = roughMap(64, 1);
  const TeQuadtree tree = TeQuadtree::create(map).value();
  for (int row = 0; row <= 64; row++)
    for (int column = 0; column <= 64; column++)
      ASSERT_EQ(tree.height(column, row), map.at(column, row));
  EXPECT_EQ(tree.squareCount(), (4096 - 1) / 3);
  EXPECT_LE(double(tree.bytes()) / (65 * 65), 12.2); // the document's 12 bytes a vertex
}

TEST(TeQuadtree, ErrorsAreTheDeviationsOverAllSamples) {
  std::mt19937 random(2);
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    const TeHeightMap map = stressMap(StressField(kind), 32, random);
    const TeQuadtree tree = TeQuadtree::create(map).value();
    const auto vertex = [&](int x, int y) { return TeLodVertex{x, y, map.at(x, y)}; };
    for (int sideLog = 1; sideLog <= 5; sideLog++) {
      const int side = 1 << sideLog, half = side / 2;
      for (int y = 0; y < 32; y += side)
        for (int x = 0; x < 32; x += side) {
          const TeQuadtreeSquare& square = tree.square(tree.find(sideLog, x, y)->square);
          const auto expectDeviation = [&](double packed, double exact) {
            ASSERT_GE(packed, exact * (1 - 1e-6)); // teTriangleDeviation rounds, too
            ASSERT_LE(packed, exact * kStep + 1e-5);
          };
          const TeLodVertex centre = vertex(x + half, y + half);
          const TeLodVertex southWest = vertex(x, y), southEast = vertex(x + side, y);
          const TeLodVertex northEast = vertex(x + side, y + side);
          double south = double(teTriangleDeviation(map, centre, southWest, southEast));
          if (y > 0)
            south = std::max(
                south, double(teTriangleDeviation(map, vertex(x + half, y - half), southEast, southWest)));
          expectDeviation(double(teUnpack(square.southError)), south);
          double east = double(teTriangleDeviation(map, centre, southEast, northEast));
          if (x + side < 32)
            east = std::max(east, double(teTriangleDeviation(map, vertex(x + side + half, y + half),
                                                             northEast, southEast)));
          expectDeviation(double(teUnpack(square.eastError)), east);
          if (sideLog == 1)
            continue;
          const TeQuadtreeSquare& child = tree.square(tree.child(tree.find(sideLog, x, y)->square, 0));
          expectDeviation(
              double(teUnpack(child.centreError)),
              std::max(double(teTriangleDeviation(map, centre, vertex(x + side, y + half), northEast)),
                       double(teTriangleDeviation(map, centre, northEast, vertex(x + half, y + side)))));
        }
    }
  }
}

TEST(TeQuadtree, RangesHoldAllSamples) {
  const TeHeightMap map = roughMap(64, 3);
  const TeQuadtree tree = TeQuadtree::create(map).value();
  for (int sideLog = 1; sideLog <= 6; sideLog++)
    for (int y = 0; y < 64; y += 1 << sideLog)
      for (int x = 0; x < 64; x += 1 << sideLog) {
        const TeQuadtreeSquare& square = tree.square(tree.find(sideLog, x, y)->square);
        const TeMapStatistics statistics =
            map.statistics({x, y, (1 << sideLog) + 1, (1 << sideLog) + 1}).value();
        ASSERT_LE(square.low(), double(statistics.minimum));
        ASSERT_GE(square.high(), double(statistics.maximum));
        // They are rounded up on each level.
        ASSERT_LE(square.high() - square.low(),
                  (double(statistics.maximum) - double(statistics.minimum)) * 1.02 + 1e-5);
      }
}

TEST(TeQuadtree, SparseRegionsFitDenseOnes) {
  TeQuadtree tree = TeQuadtree::create(9, {1, 2, 3, 4}).value();
  ASSERT_TRUE(tree.insert(roughMap(32, 4), 0, 0, 4));     // all of it, 16 apart
  ASSERT_TRUE(tree.insert(roughMap(32, 5), 128, 256, 2)); // part of it, 4 apart
  ASSERT_TRUE(tree.insert(roughMap(24, 6), 204, 284, 0)); // 1 apart, at no square's corner
  EXPECT_LT(tree.squareCount(), 4000);                    // of 87381
  const TeHeightMap coarse = roughMap(32, 4), fine = roughMap(24, 6);
  for (int row = 0; row <= 24; row++)
    for (int column = 0; column <= 24; column++)
      ASSERT_EQ(tree.height(204 + column, 284 + row), fine.at(column, row));
  for (int row = 1; row < 32; row++)
    for (int column = 1; column < 8; column++)
      ASSERT_EQ(tree.height(column * 16, row * 16), coarse.at(column, row));
  EXPECT_FALSE(tree.height(401, 31));

  std::mt19937 random(7);
  for (int trial = 0; trial < 30; trial++)
    for (const double pixelError : {0.0, 1.0, 20.0})
      expectFits(tree, viewFrom(anyEye(random, 512, 100)), pixelError);
}

TEST(TeQuadtree, OrderOfMapsDoesNotMatter) {
  const TeHeightMap all = roughMap(128, 1);
  struct Part {
    int column, row, level;
  };
  const std::vector<Part> parts = {{0, 0, 3}, {32, 32, 1}, {96, 16, 0}};
  const auto build = [&](const std::vector<int>& order) {
    TeQuadtree tree = TeQuadtree::create(7, {0, 0, 0, 0}).value();
    for (const int which : order) {
      const Part& part = parts[std::size_t(which)];
      TeHeightMap map = TeHeightMap::create(17, 17).value();
      for (int y = 0; y <= 16; y++)
        for (int x = 0; x <= 16; x++)
          map.at(x, y) = all.at(part.column + (x << part.level), part.row + (y << part.level));
      EXPECT_TRUE(tree.insert(map, part.column, part.row, part.level));
    }
    return heightsOf(tree);
  };
  const auto wanted = build({0, 1, 2});
  EXPECT_GT(wanted.size(), 700u);
  EXPECT_TRUE(build({2, 1, 0}) == wanted);
  EXPECT_TRUE(build({1, 2, 0}) == wanted);
  EXPECT_TRUE(build({2, 0, 1}) == wanted);
}

TEST(TeQuadtree, DroppedDetailIsMadeAgainBitForBit) {
  const auto detail = std::make_shared<const TeFractalDetail>(11, 0.1);
  TeQuadtree tree = TeQuadtree::create(9, {0, 5, 2, 8}, detail).value();
  ASSERT_TRUE(tree.insert(roughMap(16, 8), 0, 0, 5));
  const std::int64_t bare = tree.squareCount();

  EXPECT_GT(tree.detailAround(100, 120, 4).made, 0);
  const auto first = heightsOf(tree);
  EXPECT_TRUE(tree.height(101, 121)); // down to the smallest squares
  EXPECT_FALSE(tree.height(401, 421));
  expectFits(tree, viewFrom({100, 120, 10}), 0);

  tree.detailAround(400, 420, 4); // the viewer has left
  EXPECT_FALSE(tree.height(101, 121));
  EXPECT_TRUE(tree.height(401, 421));
  expectFits(tree, viewFrom({100, 120, 10}), 0);
  tree.detailAround(110, 260, 4); // on another way back
  tree.detailAround(100, 120, 4);
  for (const auto& [place, height] : first)
    ASSERT_EQ(tree.height(place.first, place.second), height);

  EXPECT_GT(tree.dropDetail().dropped, 0);
  EXPECT_EQ(tree.squareCount(), bare);
}

TEST(TeQuadtree, ErrorsAfterDetailAreThoseOfAllAtOnce) {
  const auto detail = std::make_shared<const TeFractalDetail>(12, 0.1);
  TeQuadtree moved = TeQuadtree::create(8, {0, 5, 2, 8}, detail).value();
  ASSERT_TRUE(moved.insert(roughMap(16, 8), 0, 0, 4));
  for (int step = 0; step < 20; step++)
    moved.detailAround(10 * step, 100 + 3 * step, 3);
  moved.dropDetail();
  moved.detailAround(77, 99, 3);
  TeQuadtree fresh = TeQuadtree::create(8, {0, 5, 2, 8}, detail).value();
  ASSERT_TRUE(fresh.insert(roughMap(16, 8), 0, 0, 4));
  fresh.detailAround(77, 99, 3);
  ASSERT_EQ(moved.squareCount(), fresh.squareCount());
  for (int sideLog = 1; sideLog <= 8; sideLog++)
    for (int y = 0; y < 256; y += 1 << sideLog)
      for (int x = 0; x < 256; x += 1 << sideLog) {
        const auto a = moved.find(sideLog, x, y), b = fresh.find(sideLog, x, y);
        ASSERT_EQ(bool(a), bool(b));
        if (!a)
          continue;
        const TeQuadtreeSquare& one = moved.square(a->square);
        const TeQuadtreeSquare& other = fresh.square(b->square);
        ASSERT_EQ(one.link & 127, other.link & 127);
        ASSERT_EQ(one.centreError, other.centreError);
        ASSERT_EQ(one.eastError, other.eastError);
        ASSERT_EQ(one.southError, other.southError);
        ASSERT_EQ(one.largestError, other.largestError);
        ASSERT_EQ(one.below, other.below);
        ASSERT_EQ(one.above, other.above);
      }
}

TEST(TeQuadtree, StaticSquaresStay) {
  const auto detail = std::make_shared<const TeFractalDetail>(13, 0.1);
  TeQuadtree tree = TeQuadtree::create(8, {0, 5, 2, 8}, detail).value();
  tree.detailAround(40, 40, 3);
  tree.setStatic(38, 38, 4, 4, true);
  tree.dropDetail();
  EXPECT_TRUE(tree.height(39, 39));
  EXPECT_FALSE(tree.height(61, 61));
  expectFits(tree, viewFrom({100, 120, 10}), 0);
  tree.setStatic(0, 0, 256, 256, false);
  tree.dropDetail();
  EXPECT_EQ(tree.squareCount(), 1);
}

TEST(TeQuadtree, MeshFollowsDetailThatComesAndGoes) {
  const auto detail = std::make_shared<const TeFractalDetail>(14, 0.1);
  TeQuadtree tree = TeQuadtree::create(9, {0, 5, 2, 8}, detail).value();
  ASSERT_TRUE(tree.insert(roughMap(16, 8), 0, 0, 5));
  TeQuadtreeMesh mesh(tree, {});
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = 0.5;
  for (int step = 0; step < 60; step++) {
    const double x = 30 + 7 * step % 400, y = 256 + 200 * std::sin(step * 0.3);
    tree.detailAround(x, y, 3);
    const TeLodView view = viewFrom({x, y, 20});
    mesh.update(view, wish);
    ASSERT_EQ(mesh.inconsistency(), "");
    TeQuadtreeMesh fresh(tree, {});
    fresh.update(view, wish);
    TeLodMesh kept, made;
    mesh.append(kept);
    fresh.append(made);
    ASSERT_EQ(kept.indices, made.indices);
    for (std::size_t i = 0; i < kept.vertices.size(); i++)
      ASSERT_EQ(kept.vertices[i].height, made.vertices[i].height);
  }
}

TEST(TeQuadtree, RefusesWhatDoesNotFit) {
  EXPECT_FALSE(TeQuadtree::create(0, {0, 0, 0, 0}));
  EXPECT_FALSE(TeQuadtree::create(21, {0, 0, 0, 0}));
  EXPECT_FALSE(TeQuadtree::create(4, {0, 0, NAN, 0}));
  EXPECT_FALSE(TeQuadtree::create(TeHeightMap::create(6, 6).value()));
  TeHeightMap map = roughMap(8, 1);
  TeQuadtree tree = TeQuadtree::create(8, {0, 0, 0, 0}).value();
  EXPECT_FALSE(tree.insert(map, 0, 0, 8));
  EXPECT_FALSE(tree.insert(map, 3, 0, 1));
  map.at(3, 4) = TeHeightMap::missing();
  EXPECT_FALSE(TeQuadtree::create(map));
  EXPECT_TRUE(tree.insert(map, 64, 64, 0)); // the missing one is derived
  EXPECT_TRUE(tree.height(67, 68));
  map.at(3, 4) = INFINITY;
  EXPECT_FALSE(tree.insert(map, 0, 0, 0));
}

TEST(TeQuadtree, SpansAMetreToAHundredKilometres) {
  TeQuadtree tree = TeQuadtree::create(17, {0, 0, 0, 0}).value(); // 131 km of 1 m
  ASSERT_TRUE(tree.insert(roughMap(64, 1), 0, 0, 11));
  ASSERT_TRUE(tree.insert(roughMap(64, 2), 70000, 50000, 0));
  EXPECT_EQ(tree.height(70001, 50001), roughMap(64, 2).at(1, 1));
  EXPECT_LT(tree.squareCount(), 10000);
  TeQuadtreeMesh mesh(tree, {});
  mesh.update(viewFrom({70032, 50032, 60}), {});
  EXPECT_EQ(mesh.inconsistency(), "");
  EXPECT_GT(mesh.result().triangles, 2000);
}
