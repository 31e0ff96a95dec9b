#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <gtest/gtest.h>

namespace {

TeHeightMap flat(int samples, float height) {
  TeHeightMap map = TeHeightMap::create(samples, samples).value();
  EXPECT_TRUE(map.fill(height, map.bounds()));
  return map;
}

} // namespace

TEST(DocsQuadtree, SparseAndProcedural) {
  const TeHeightMap coarse = flat(257, 100), road = flat(65, 101);
  TeLodView view;
  view.eye = {70030, 50030, 140};
  view.focal = 665;
  TeLodMesh triangles;
  //! [sparse]
  const auto detail = std::make_shared<const TeFractalDetail>(2007, 0.01);
  TeResult<TeQuadtree> tree = TeQuadtree::create(17, {100, 100, 100, 100}, detail); // 131072 m a side
  ASSERT_TRUE(tree);
  ASSERT_TRUE(tree->insert(coarse, 0, 0, 9));             // samples 512 m apart, over all of it
  ASSERT_TRUE(tree->insert(road, 70000, 50000, 0, true)); // 1 m apart; static

  TeQuadtreeMesh mesh(*tree, {}); // spacing 1 m
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = 2;
  // Each frame: squares are made around the viewer, and dropped elsewhere.
  tree->detailAround(view.eye.x, view.eye.y, 6);
  if (mesh.update(view, wish).changed)
    mesh.append(triangles);
  //! [sparse]
  EXPECT_GT(mesh.result().triangles, 100);
  EXPECT_LE(mesh.result().errorBound, 2);
  EXPECT_EQ(tree->height(70001, 50001), 101);
  EXPECT_EQ(mesh.inconsistency(), "");
}
