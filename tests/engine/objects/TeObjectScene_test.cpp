#include "engine/objects/TeObjectScene.h"

#include "engine/objects/TeObject.h"
#include "nodes/TeNodes.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <gtest/gtest.h>

namespace {

class Box : public TeObject {
public:
  Box() : TeObject("box") { TeNodes::init(); }
  SoNode* drawModel() override { return new SoCube; }
};

class Ghost : public TeObject {
public:
  Ghost() : TeObject("ghost") { TeNodes::init(); }
};

SbVec3f centreOf(const TeObjectScene& scene) {
  SoGetBoundingBoxAction box(SbViewportRegion(100, 100));
  box.apply(scene.root());
  return box.getBoundingBox().isEmpty() ? SbVec3f(0, 0, 0) : box.getBoundingBox().getCenter();
}

TEST(TeObjectScene, ModelsLieRelativeToTheOriginHoweverFarOut) {
  Box box;
  TeObjectScene scene;
  ASSERT_TRUE(box.setPosition({1e9 + 0.125, -1e9, 3}));
  scene.add(box, {1e9, -1e9, 0});
  EXPECT_EQ(centreOf(scene), SbVec3f(0.125f, 0, 3));
  scene.placeAll({1e9 - 8, -1e9, 0});
  EXPECT_EQ(centreOf(scene), SbVec3f(8.125f, 0, 3));
}

TEST(TeObjectScene, AnObjectThatStandsStillChangesNoNode) {
  Box box;
  TeObjectScene scene;
  scene.add(box, {0, 0, 0});
  int changes = 0;
  SoNodeSensor sensor([](void* count, SoSensor*) { ++*static_cast<int*>(count); }, &changes);
  sensor.setPriority(0);
  sensor.attach(scene.root());
  scene.place(box, {0, 0, 0});
  EXPECT_EQ(changes, 0);
  ASSERT_TRUE(box.setPosition({1, 0, 0}));
  scene.place(box, {0, 0, 0});
  EXPECT_EQ(changes, 1);
}

TEST(TeObjectScene, TheObjectThatTheCameraIsInIsHidden) {
  Box a, b;
  TeObjectScene scene;
  ASSERT_TRUE(a.setPosition({10, 0, 0}));
  ASSERT_TRUE(b.setPosition({-20, 0, 0}));
  scene.add(a, {0, 0, 0});
  scene.add(b, {0, 0, 0});
  scene.setHidden(&a);
  EXPECT_EQ(centreOf(scene), SbVec3f(-20, 0, 0));
  scene.setHidden(&b);
  EXPECT_EQ(centreOf(scene), SbVec3f(10, 0, 0));
  scene.remove(b);
  scene.setHidden(nullptr);
  EXPECT_EQ(centreOf(scene), SbVec3f(10, 0, 0));
}

TEST(TeObjectScene, ObjectsWithoutModelsTakeNothing) {
  Ghost ghost;
  TeObjectScene scene;
  scene.add(ghost, {0, 0, 0});
  EXPECT_EQ(scene.root()->getNumChildren(), 0);
  scene.place(ghost, {0, 0, 0});
  scene.setHidden(&ghost);
  scene.remove(ghost);
}

} // namespace
