#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

constexpr int kCells = 128;

TeLodView jump(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  TeLodView view = viewFrom(anyEye(random, kCells, 0.3 * kCells), uniform(100, 3000));
  if (random() % 2 == 0)
    lookAlong(view, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)}, uniform(0.05, 1.4));
  return view;
}

TeQuadtreeMesh::Wish anyWish(std::mt19937& random) {
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = std::exp(std::uniform_real_distribution<double>(-1, 5)(random));
  if (random() % 2 == 0)
    wish.threshold = std::exp(std::uniform_real_distribution<double>(0, 5)(random));
  wish.geomorph = random() % 3 == 0;
  return wish;
}

/// Bit for bit.
bool areEqual(const TeLodMesh& a, const TeLodMesh& b) {
  return a.indices == b.indices && a.vertices.size() == b.vertices.size() &&
         std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(TeLodVertex)) == 0;
}

} // namespace

TEST(TeQuadtreeMesh, CountsAreRightAfterThousandsOfJumps) {
  std::mt19937 random(1);
  for (const StressField kind : {StressField::Rough, StressField::Spike, StressField::Plateau}) {
    const TeQuadtree tree = TeQuadtree::create(stressMap(kind, kCells / 2, random)).value();
    TeQuadtreeMesh mesh(tree, {});
    std::int64_t changes = 0;
    for (int trial = 0; trial < 1000; trial++) {
      mesh.update(jump(random), anyWish(random));
      ASSERT_EQ(mesh.inconsistency(), "");
      changes += mesh.result().enabled + mesh.result().disabled;
    }
    EXPECT_GT(changes, 1000);
  }
}

TEST(TeQuadtreeMesh, HistoryDoesNotMatter) {
  std::mt19937 random(2);
  for (const StressField kind : {StressField::Rough, StressField::Spike, StressField::Cliff}) {
    const TeQuadtree tree = TeQuadtree::create(stressMap(kind, kCells, random)).value();
    TeQuadtreeMesh mesh(tree, {});
    for (int trial = 0; trial < 100; trial++) {
      const TeLodView view = jump(random);
      const TeQuadtreeMesh::Wish wish = anyWish(random);
      mesh.update(view, wish);
      TeQuadtreeMesh fresh(tree, {});
      fresh.update(view, wish);
      TeLodMesh kept, made;
      mesh.append(kept);
      fresh.append(made);
      ASSERT_TRUE(areEqual(kept, made)) << kept.triangles() << " and " << made.triangles();
      ASSERT_EQ(mesh.result().errorBound, fresh.result().errorBound);
      ASSERT_EQ(mesh.result().visited, fresh.result().visited);
    }
  }
}

TEST(TeQuadtreeMesh, StillEyeChangesNothing) {
  std::mt19937 random(4);
  const TeQuadtree tree = TeQuadtree::create(stressMap(StressField::Rough, kCells, random)).value();
  TeQuadtreeMesh mesh(tree, {});
  TeQuadtreeMesh::Wish wish;
  for (int trial = 0; trial < 20; trial++) {
    const TeLodView view = jump(random);
    mesh.update(view, wish);
    mesh.update(view, wish);
    EXPECT_FALSE(mesh.result().changed);
    EXPECT_EQ(mesh.result().enabled + mesh.result().disabled, 0);
  }
}

// The document's rule: at distance z an error of z / threshold is accepted.
TEST(TeQuadtreeMesh, ThresholdIsTheDocuments) {
  std::mt19937 random(5);
  const TeHeightMap map = stressMap(StressField::Rough, kCells, random);
  const TeQuadtree tree = TeQuadtree::create(map).value();
  TeQuadtreeMesh mesh(tree, {});
  const glm::dvec3 eye(40, 50, 30);
  std::int64_t before = 0;
  for (const double threshold : {2.0, 8.0, 32.0, 128.0}) {
    TeQuadtreeMesh::Wish wish;
    wish.threshold = threshold;
    mesh.update(viewFrom(eye), wish);
    EXPECT_GT(mesh.result().triangles, before); // a larger threshold is finer
    before = mesh.result().triangles;
    TeLodMesh drawn;
    mesh.append(drawn);
    std::vector<bool> isVertex(std::size_t(kCells + 1) * (kCells + 1));
    for (const TeLodVertex& vertex : drawn.vertices)
      isVertex[std::size_t(vertex.row * (kCells + 1) + vertex.column)] = true;
    // Every middle of an edge that fails the vertex test is a vertex: here those of the smallest squares.
    for (int row = 1; row < kCells; row++)
      for (int column = 1 + row % 2; column < kCells; column += 2) {
        const bool isLevel = column % 2 == 1; // on an edge from west to east
        const float a = isLevel ? map.at(column - 1, row) : map.at(column, row - 1);
        const float b = isLevel ? map.at(column + 1, row) : map.at(column, row + 1);
        const double height = double(map.at(column, row));
        const double error = std::fabs(height - (double(a) + double(b)) / 2);
        const double distance =
            std::max({std::fabs(column - eye.x), std::fabs(row - eye.y), std::fabs(height - eye.z)});
        if (error * threshold > distance) {
          ASSERT_TRUE(isVertex[std::size_t(row * (kCells + 1) + column)]) << column << ", " << row;
        }
      }
  }
}

TEST(TeQuadtreeMesh, ExtremeViewsStayWithinTheData) {
  std::mt19937 random(6);
  const TeQuadtree tree = TeQuadtree::create(stressMap(StressField::Rough, kCells, random)).value();
  TeQuadtreeMesh mesh(tree, {});
  for (const double focal : {1e-6, 1.0, 1e9}) {
    for (const bool perspective : {true, false}) {
      TeLodView view = viewFrom({64, 64, 10}, focal);
      view.perspective = perspective;
      mesh.update(view, {});
      EXPECT_LE(mesh.result().triangles, 2 * kCells * kCells);
      EXPECT_GE(mesh.result().triangles, 4);
      EXPECT_LE(mesh.result().errorBound, 1 + 1e-9);
      EXPECT_EQ(mesh.inconsistency(), "");
    }
  }
}
