#include "nodes/terrain/SoTeTerrainMesh.h"

#include "nodes/askScene.h"
#include "nodes/gridMesh.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoRotationXYZ.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

// Sample 16 of a lattice of 65 samples lies at 0.
float hills(double x, double y) { return float(6 * std::sin(x / 5) * std::cos(y / 7)); }

/// One mesh below its drawing's translation; the anchor is the scene's origin at first.
class SoTeTerrainMeshNode : public testing::Test {
protected:
  void build(TePatchMesh mesh, glm::dvec2 anchor = {0, 0}) {
    m_drawing = std::make_shared<TeMeshDrawing>(anchor);
    m_drawing->setWorldOrigin({anchor, 0});
    m_node = TeNodePtr<SoTeTerrainMesh>(new SoTeTerrainMesh);
    m_node->setMesh(std::make_shared<const TePatchMesh>(std::move(mesh)), {}, m_drawing);
    m_root = TeNodePtr<SoSeparator>(new SoSeparator);
    m_root->addChild(m_drawing->translation());
    m_root->addChild(m_node.get());
  }

  const SoPickedPoint* pick(SbVec3f from, SbVec3f direction) {
    m_pick.setRay(from, direction);
    m_pick.apply(m_root.get());
    return m_pick.getPickedPoint();
  }

  const SoTeTerrainDetail* detail(const SoPickedPoint* point) const {
    return static_cast<const SoTeTerrainDetail*>(point->getDetail(m_node.get()));
  }

  std::shared_ptr<TeMeshDrawing> m_drawing;
  TeNodePtr<SoTeTerrainMesh> m_node;
  TeNodePtr<SoSeparator> m_root;
  SoRayPickAction m_pick{kViewport};
};

} // namespace

TEST_F(SoTeTerrainMeshNode, IsKnownByItsPublicName) {
  EXPECT_EQ(SoTeTerrainMesh::getClassTypeId().getName(), SbName("TeTerrainMesh"));
  const TeNodePtr<SoNode> made(static_cast<SoNode*>(SoType::fromName("TeTerrainMesh").createInstance()));
  ASSERT_TRUE(made);
  EXPECT_EQ(triangles(made.get()), 0);
  EXPECT_TRUE(boxOf(made.get()).isEmpty());
}

TEST_F(SoTeTerrainMeshNode, GivesTheTrianglesThatItCounts) {
  build(gridMesh(*TeLattice::create(65, 1), -10, -10, 31, 21, hills));
  EXPECT_EQ(triangles(m_root.get()), 2 * 30 * 20);
  struct Sum {
    int triangles = 0;
    double area = 0; ///< seen from above
  } sum;
  SoCallbackAction action;
  action.addTriangleCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        const SbVec3f normal = (b->getPoint() - a->getPoint()).cross(c->getPoint() - a->getPoint());
        static_cast<Sum*>(data)->triangles++;
        static_cast<Sum*>(data)->area += 0.5 * double(normal[2]);
        EXPECT_EQ(a->getNormal(), SbVec3f(0, 0, 1));
      },
      &sum);
  action.apply(m_root.get());
  EXPECT_EQ(sum.triangles, 2 * 30 * 20);
  EXPECT_NEAR(sum.area, 30 * 20, 1e-3);
}

TEST_F(SoTeTerrainMeshNode, BoxIsTightAndFollowsTheAnchor) {
  const TeLattice grid = *TeLattice::create(65, 1);
  build(gridMesh(grid, 1000, 0, 31, 31, hills), {1000, 0});
  float lowest = 1e9f;
  float highest = -1e9f;
  for (const glm::vec3& position : m_node->mesh()->positions) {
    lowest = std::min(lowest, position.z);
    highest = std::max(highest, position.z);
  }
  const SbBox3f box = boxOf(m_root.get());
  EXPECT_EQ(box.getMin()[0], float(grid.position(1000) - 1000));
  EXPECT_EQ(box.getMax()[1], float(grid.position(30)));
  EXPECT_EQ(box.getMin()[2], lowest);
  EXPECT_EQ(box.getMax()[2], highest);

  // In the scene nothing moves with the anchor; in the node's own coordinates everything does.
  m_drawing->setAnchor({1016, 8});
  EXPECT_EQ(boxOf(m_root.get()).getMin(), box.getMin());
  EXPECT_EQ(boxOf(m_root.get()).getMax(), box.getMax());
  EXPECT_EQ(boxOf(m_node.get()).getMin(), box.getMin() - SbVec3f(16, 8, 0));
}

TEST_F(SoTeTerrainMeshNode, BoxLeavesOutVerticesOfMissingCells) {
  TePatchMesh mesh = gridMesh(*TeLattice::create(65, 1), 0, 0, 3, 2, [](double, double) { return 50.0f; });
  mesh.positions[2].z = mesh.positions[5].z = 0;
  mesh.strips = {3, 0, 4, 1, -1};
  build(mesh);
  EXPECT_EQ(boxOf(m_root.get()).getMin()[2], 50);
  EXPECT_EQ(triangles(m_root.get()), 2);
}

TEST_F(SoTeTerrainMeshNode, IsPickedWithItsPlaceInTheWorld) {
  const TeLattice grid = *TeLattice::create(65, 1);
  const glm::dvec2 anchor(grid.position(1 << 20), grid.position(-(1 << 20)));
  TePatchMesh mesh = gridMesh(grid, (1 << 20) - 15, -(1 << 20) - 15, 31, 31,
                              [&](double x, double) { return float(2 * (x - anchor.x)); });
  mesh.key = {32768, -32768, 0};
  build(mesh, anchor);
  const SoPickedPoint* point = pick(SbVec3f(3.25f, -4.5f, 100), SbVec3f(0, 0, -1));
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->getPoint()[2], 6.5, 1e-4);
  const SoTeTerrainDetail* hit = detail(point);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->getPatchKey(), (TePatchKey{32768, -32768, 0}));
  EXPECT_NEAR(hit->getPosition().x, anchor.x + 3.25, 1e-5);
  EXPECT_NEAR(hit->getPosition().y, anchor.y - 4.5, 1e-5);
  EXPECT_NEAR(hit->getHeight(), 6.5, 1e-4);
  EXPECT_NEAR(hit->getNormal().x, -2 / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(hit->getNormal().z, 1 / std::sqrt(5.0), 1e-6);
  EXPECT_EQ(pick(SbVec3f(16, 0, 100), SbVec3f(0, 0, -1)), nullptr); // beside it
}

TEST_F(SoTeTerrainMeshNode, TheNearestTriangleIsPicked) {
  build(gridMesh(*TeLattice::create(65, 1), 1, 1, 31, 31, hills));
  const SbVec3f from(-40, 1, 4);
  const SoPickedPoint* point = pick(from, SbVec3f(1, 0, -0.05f));
  ASSERT_TRUE(point);
  const SbVec3f nearest = point->getPoint();
  m_pick.setPickAll(TRUE);
  ASSERT_TRUE(pick(from, SbVec3f(1, 0, -0.05f)));
  EXPECT_GT(m_pick.getPickedPointList().getLength(), 1); // in and out of the hills
  for (int i = 0; i < m_pick.getPickedPointList().getLength(); i++)
    EXPECT_LE((nearest - from).length(), (m_pick.getPickedPoint(i)->getPoint() - from).length());
}

TEST_F(SoTeTerrainMeshNode, PickingKnowsTransformsAndPickStyles) {
  build(gridMesh(*TeLattice::create(65, 1), 1, 1, 31, 31, hills));
  auto* rotation = new SoRotationXYZ; // stands upright: y up
  rotation->axis = SoRotationXYZ::X;
  rotation->angle = float(-M_PI / 2);
  m_root->insertChild(rotation, 0);
  const SoPickedPoint* point = pick(SbVec3f(2, 100, -3), SbVec3f(0, -1, 0));
  ASSERT_TRUE(point);
  EXPECT_NEAR(detail(point)->getPosition().x, 2, 1e-4);
  EXPECT_NEAR(detail(point)->getPosition().y, 3, 1e-4);
  auto* style = new SoPickStyle;
  style->style = SoPickStyle::UNPICKABLE;
  m_root->insertChild(style, 0);
  EXPECT_EQ(pick(SbVec3f(2, 100, -3), SbVec3f(0, -1, 0)), nullptr);
}

TEST_F(SoTeTerrainMeshNode, ACopyHasTheMeshToo) {
  build(gridMesh(*TeLattice::create(65, 1), 0, 0, 11, 11, hills));
  const TeNodePtr<SoNode> copy(m_root->copy());
  m_root = TeNodePtr<SoSeparator>();
  m_node = TeNodePtr<SoTeTerrainMesh>();
  EXPECT_EQ(triangles(copy.get()), 200);
  EXPECT_FALSE(boxOf(copy.get()).isEmpty());
}

TEST_F(SoTeTerrainMeshNode, TellsWhatItUploads) {
  build(gridMesh(*TeLattice::create(65, 1), 0, 0, 31, 31, hills));
  EXPECT_EQ(m_node->uploadBytes(), 24u * 31 * 31);
  EXPECT_EQ(m_drawing->bufferBytes(), 0u);
  m_node->setMesh(nullptr, {}, m_drawing);
  EXPECT_EQ(m_node->uploadBytes(), 0u);
}

TEST_F(SoTeTerrainMeshNode, PickingAndCountsStayThoseOfAllTriangles) {
  build(gridMesh(*TeLattice::create(65, 1), 1, 1, 31, 31, hills));
  const SoPickedPoint* point = pick(SbVec3f(6.25f, 5.5f, 100), SbVec3f(0, 0, -1));
  ASSERT_TRUE(point);
  const SbVec3f before = point->getPoint();
  m_drawing->setPixelError(1000);
  point = pick(SbVec3f(6.25f, 5.5f, 100), SbVec3f(0, 0, -1));
  ASSERT_TRUE(point);
  EXPECT_EQ(point->getPoint(), before);
  EXPECT_EQ(triangles(m_root.get()), 2 * 30 * 30);
  EXPECT_EQ(m_node->level(), 0) << "until it is drawn";
  EXPECT_TRUE(m_node->levelErrors().empty()) << "until it is drawn";
}
