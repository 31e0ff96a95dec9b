#include "nodes/terrain/TeBlockGraph.h"
#include "nodes/testWorld.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoNormal.h>
#include <Inventor/nodes/SoPackedColor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace {

template <class Node> std::vector<Node*> all(SoNode* root) {
  SoSearchAction search;
  search.setType(Node::getClassTypeId());
  search.setInterest(SoSearchAction::ALL);
  search.apply(root);
  std::vector<Node*> nodes;
  for (int i = 0; i < search.getPaths().getLength(); i++)
    nodes.push_back(static_cast<Node*>(search.getPaths()[i]->getTail()));
  return nodes;
}

int countNotFinite(const SoMFVec3f& field) {
  int count = 0;
  for (int i = 0; i < field.getNum(); i++) {
    for (int axis = 0; axis < 3; axis++)
      count += !std::isfinite(field[i][axis]);
  }
  return count;
}

} // namespace

// Whatever a source answers, what goes to OpenGL is finite, and cells with a missing corner are left out.
TEST(HardCase, NaNAndNoDataNodes) {
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                       -std::numeric_limits<float>::infinity()};
  std::int64_t values = 0;
  int pieces = 0;
  for (const float value : bad) {
    for (const int every : {1, 2, 5, 37}) {
      const auto source = std::make_shared<TeSampleFunction>([&](std::int64_t x, std::int64_t y) {
        return (x + 7 * y) % every == 0 ? value : float(x - y) * 0.1f;
      });
      const auto block = TeStaticBlock::build(worldOf(source, 17), {0, 0}, 3);
      ASSERT_TRUE(block) << block.error().message;
      EXPECT_TRUE(std::isfinite(block->minimum()) && std::isfinite(block->maximum()));
      const auto graph = teBlockGraph(*block);
      ASSERT_TRUE(graph) << graph.error().message;
      for (const SoCoordinate3* node : all<SoCoordinate3>(graph->get())) {
        EXPECT_EQ(countNotFinite(node->point), 0);
        values += 3 * node->point.getNum();
        pieces++;
      }
      for (const SoNormal* node : all<SoNormal>(graph->get())) {
        EXPECT_EQ(countNotFinite(node->vector), 0);
        values += 3 * node->vector.getNum();
      }
      SoGetBoundingBoxAction bounds(SbViewportRegion(10, 10));
      bounds.apply(graph->get());
      // A chessboard of missing samples leaves no cell whole.
      EXPECT_EQ(bounds.getBoundingBox().isEmpty(), every <= 2);
    }
  }
  EXPECT_GT(pieces, 0);
  std::printf("HardCase.NaNAndNoDataNodes: %lld floats of %d pieces for OpenGL, all finite\n",
              static_cast<long long>(values), pieces);
}
