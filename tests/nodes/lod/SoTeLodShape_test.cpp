#include "nodes/lod/SoTeLodShape.h"

#include "nodes/SceneChanges.h"
#include "nodes/badFields.h"
#include "nodes/lod/lodShape.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/nodes/SoComplexity.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

namespace {

/// What every shape must do, whichever method chooses its triangles …
class EveryLodShape : public testing::TestWithParam<std::string> {};

/// … and what does not depend on that: for one shape of each class.
class BothLodShapes : public testing::TestWithParam<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodShape, EveryLodShape, testing::ValuesIn(lodShapeNames()), testName);
INSTANTIATE_TEST_SUITE_P(SoTeLodShape, BothLodShapes, testing::Values("seamless", kPatches), testName);

TEST(SoTeLodShape, IsAnAbstractShapeThatIsRegisteredOnce) {
  const SoType type = SoTeLodShape::getClassTypeId();
  SoTeLodShape::initClass();
  EXPECT_EQ(SoTeLodShape::getClassTypeId(), type);
  EXPECT_EQ(SoType::fromName("TeLodShape"), type);
  EXPECT_TRUE(type.isDerivedFrom(SoShape::getClassTypeId()));
  EXPECT_FALSE(type.canCreateInstance());
  EXPECT_TRUE(SoTeLodTerrain::getClassTypeId().isDerivedFrom(type));
  EXPECT_TRUE(SoTeSeamlessPatches::getClassTypeId().isDerivedFrom(type));
}

TEST(SoTeLodShape, EachClassHasDefaultsOfItsOwn) {
  const TeNodePtr<SoTeLodTerrain> terrain(new SoTeLodTerrain);
  const TeNodePtr<SoTeSeamlessPatches> patches(new SoTeSeamlessPatches);
  EXPECT_TRUE(terrain->hasDefaultValues());
  EXPECT_TRUE(patches->hasDefaultValues());
  EXPECT_EQ(terrain->pixelError.getValue(), 1);
  EXPECT_EQ(patches->pixelError.getValue(), 0);
  EXPECT_EQ(terrain->size.getValue(), patches->size.getValue());
}

// Without a camera everything is there.
TEST_P(EveryLodShape, CoversTheWholeSquare) {
  const auto node = lodShape(GetParam());
  for (const float error : {8.0f, 0.5f}) {
    node->pixelError = error;
    const std::vector<EmittedTriangle> mesh = emitted(node.get());
    EXPECT_EQ(int(mesh.size()), triangles(node.get()));
    EXPECT_NEAR(areaFromAbove(mesh), 1e6, 1);
  }
  EXPECT_EQ(boxOf(node.get()).getMin()[0], -500);
  EXPECT_EQ(boxOf(node.get()).getMax()[1], 500);
}

TEST_P(EveryLodShape, BoundingBoxHoldsEverything) {
  const auto node = lodShape(GetParam());
  const SbBox3f box = boxOf(node.get());
  int outside = 0;
  for (const EmittedTriangle& t : emitted(node.get()))
    for (const SbVec3f& corner : t) // skirts may be lower
      outside += corner[0] < box.getMin()[0] || corner[0] > box.getMax()[0] || corner[1] < box.getMin()[1] ||
                 corner[1] > box.getMax()[1] || corner[2] > box.getMax()[2];
  EXPECT_EQ(outside, 0);
}

TEST_P(EveryLodShape, CameraDecidesWhatThereIs) {
  const auto node = lodShape(GetParam());
  const auto near = seenBy(SbVec3f(-400, -400, 200), SbVec3f(0, 0, 100), node.get());
  const auto away = seenBy(SbVec3f(-400, -400, 200), SbVec3f(-900, -900, 100), node.get());
  EXPECT_GT(triangles(near.get()), 1000);
  EXPECT_LT(triangles(away.get()), triangles(near.get()) / 4);
  EXPECT_EQ(int(emitted(near.get()).size()), triangles(near.get()));
}

TEST_P(EveryLodShape, RaysMeetWhatIsDrawn) {
  const auto node = lodShape(GetParam());
  const auto root = seenBy(SbVec3f(-450, -450, 250), SbVec3f(0, 0, 100), node.get());
  const std::vector<EmittedTriangle> mesh = emitted(root.get());
  std::mt19937 numbers(3);
  SoRayPickAction pick(kViewport);
  for (int i = 0; i < 60;) {
    // Into the middle of a triangle, somewhat aslant.
    const EmittedTriangle& t = mesh[numbers() % mesh.size()];
    if ((t[1] - t[0]).cross(t[2] - t[0])[2] <= 0)
      continue; // a skirt
    i++;
    const SbVec3f middle = (t[0] + t[1] + t[2]) / 3;
    const SbVec3f from = middle + SbVec3f(3, -4, 400);
    pick.setRay(from, middle - from);
    pick.apply(root.get());
    const SoPickedPoint* point = pick.getPickedPoint();
    ASSERT_TRUE(point);
    EXPECT_LT((point->getPoint() - middle).length(), 1e-2f);
    const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(node.get()));
    ASSERT_TRUE(detail);
    EXPECT_NEAR(detail->getHeight(), double(middle[2]), 1e-2);
    EXPECT_GT(detail->getNormal().z, 0);
  }
  // Behind the camera nothing is drawn, but rays meet the ground.
  EXPECT_TRUE(pickDown(pick, root.get(), -490, -490));
  EXPECT_FALSE(pickDown(pick, root.get(), -510, -490));
}

TEST_P(EveryLodShape, AllHitsAlongARay) {
  const auto node = lodShape(GetParam());
  SoRayPickAction pick(kViewport);
  pick.setPickAll(TRUE);
  pick.setRay(SbVec3f(-600, 20, 100), SbVec3f(1, 0.01f, 0));
  pick.apply(node.get());
  EXPECT_GT(pick.getPickedPointList().getLength(), 3);
  const auto root = readScene("PickStyle { style UNPICKABLE }");
  root->addChild(node.get());
  pick.apply(root.get());
  EXPECT_EQ(pick.getPickedPointList().getLength(), 0);
}

TEST_P(EveryLodShape, LiesWhereCenterAndOriginSay) {
  const auto node = lodShape(GetParam());
  const int there = triangles(node.get());
  node->center.setValue(1e8 + 100, -3e8, 50);
  node->origin.setValue(1e8, -3e8, 0);
  EXPECT_EQ(boxOf(node.get()).getMin()[0], -400);
  EXPECT_EQ(boxOf(node.get()).getMax()[1], 500);
  EXPECT_EQ(triangles(node.get()), there);
  SoRayPickAction pick(kViewport);
  const SoPickedPoint* point = pickDown(pick, node.get(), 130, 40);
  ASSERT_TRUE(point);
  const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(node.get()));
  ASSERT_TRUE(detail);
  EXPECT_NEAR(detail->getPosition().x, 1e8 + 130, 1e-3);
  EXPECT_NEAR(detail->getPosition().y, -3e8 + 40, 1e-3);
}

TEST_P(BothLodShapes, ComplexityIsTheAccuracysDial) {
  const auto node = lodShape(GetParam(), 512);
  const auto root = seenBy(SbVec3f(0, -480, 160), SbVec3f(0, 0, 100), node.get());
  auto* complexity = new SoComplexity;
  root->insertChild(complexity, 1);
  node->pixelError = 4;
  const int plain = triangles(root.get());
  complexity->value = 0.75f; // twice as accurate
  const int finer = triangles(root.get());
  EXPECT_GT(finer, plain);
  complexity->value = 0.5f;
  EXPECT_EQ(triangles(root.get()), plain);
  node->pixelError = 2;
  EXPECT_EQ(triangles(root.get()), finer);
}

TEST_P(BothLodShapes, AnotherCameraMayDecide) {
  const auto node = lodShape(GetParam());
  TeNodePtr<SoPerspectiveCamera> far(new SoPerspectiveCamera);
  far->position.setValue(0, 0, 5000);
  far->farDistance = 10000;
  const auto root = seenBy(SbVec3f(-400, -400, 200), SbVec3f(0, 0, 100), node.get());
  const int near = triangles(root.get());
  node->lodCamera = far.get();
  EXPECT_LT(triangles(root.get()), near);
  far->position.setValue(0, 0, 150);
  EXPECT_GT(triangles(root.get()), 500);
  node->lodCamera = nullptr;
  EXPECT_EQ(triangles(root.get()), near);
}

TEST_P(BothLodShapes, ChangesNotifyAndUseDoesNot) {
  const auto node = lodShape(GetParam());
  TeNodePtr<SoSeparator> root(new SoSeparator);
  root->addChild(node.get());
  SceneChanges changes(root.get());
  triangles(root.get());
  emitted(root.get());
  boxOf(root.get());
  EXPECT_EQ(changes.count, 0);
  node->pixelError = 5;
  EXPECT_EQ(changes.count, 1);
  const int before = triangles(root.get());
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(64)));
  EXPECT_EQ(changes.count, 2);
  EXPECT_NE(triangles(root.get()), before);
}

TEST_P(BothLodShapes, CopiesAreOfTheirOwn) {
  const auto node = lodShape(GetParam());
  node->pixelError = 20;
  const int before = triangles(node.get());
  const TeNodePtr<SoTeLodShape> copy(static_cast<SoTeLodShape*>(node->copy()));
  EXPECT_EQ(triangles(copy.get()), before); // heights set in C++ go with it
  EXPECT_EQ(boxOf(copy.get()), boxOf(node.get()));
  copy->pixelError = 2;
  EXPECT_GT(triangles(copy.get()), before);
  EXPECT_EQ(triangles(node.get()), before);
}

TEST_P(BothLodShapes, NotANumberIsOneWarning) {
  const float nan = std::nanf("");
  const auto node = lodShape(GetParam());
  node->pixelError = nan;
  expectOneWarningAndNothing(node.get(), "pixelError");
  node->pixelError = 2;
  node->size.setValue(nan, nan, 1);
  expectOneWarningAndNothing(node.get(), "size");
  node->size.setValue(1000, 1000, 0);
  node->center.setValue(0, double(nan), 0);
  expectOneWarningAndNothing(node.get(), "center");
  node->center.setValue(0, 0, 0);
  EXPECT_GT(triangles(node.get()), 0);
  node->origin.setValue(double(nan), 0, 0);
  expectOneWarningAndNothing(node.get(), "origin");
  node->origin.setValue(0, 0, 0);
  const CoinWarnings warnings;
  EXPECT_GT(triangles(node.get()), 0); // good again
  EXPECT_THAT(warnings.lines, testing::IsEmpty());
  EXPECT_EQ(node->getError(), "");
}

TEST_P(BothLodShapes, HeightsThatItCannotHaveAreErrors) {
  const CoinWarnings warnings;
  const auto node = lodShape(GetParam());
  TeHeightMap holes = hillsMap(64);
  holes.at(7, 9) = TeHeightMap::missing();
  node->setHeights(std::make_shared<const TeHeightMap>(std::move(holes)));
  EXPECT_THAT(node->getError(), testing::HasSubstr("missing"));
  EXPECT_EQ(triangles(node.get()), 0);
  node->setHeights(std::make_shared<const TeHeightMap>(std::move(TeHeightMap::create(17, 33).value())));
  EXPECT_FALSE(node->getError().empty());
  EXPECT_EQ(triangles(node.get()), 0);
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(64)));
  EXPECT_EQ(node->getError(), "");
}
