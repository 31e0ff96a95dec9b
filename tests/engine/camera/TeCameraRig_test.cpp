#include "engine/camera/TeCameraRig.h"

#include "engine/objects/TeObject.h"
#include "engine/objects/TeTestGround.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using Key = SoKeyboardEvent::Key;
using Person = TeCameraRig::Person;

class Ship : public TeObject {
public:
  Ship() : TeObject("ship") {}
  glm::dvec3 firstPersonOffset() const override { return {0, 2, 1}; }
  glm::dvec3 thirdPersonOffset() const override { return {0, -10, 3}; }
};

/// About an axis by degrees.
glm::dquat turned(double degrees, const glm::dvec3& axis) {
  return glm::angleAxis(glm::radians(degrees), axis);
}

void expectNear(const glm::dvec3& value, const glm::dvec3& expected, double tolerance = 1e-9) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(value[i], expected[i], tolerance) << "part " << i;
}

class TeCameraRigTest : public testing::Test {
protected:
  void press(Key key) { EXPECT_TRUE(m_rig.handleEvent({key, true})); }
  void release(Key key) { EXPECT_TRUE(m_rig.handleEvent({key, false})); }
  void tap(Key key) {
    press(key);
    release(key);
  }
  void follow() { m_rig.follow(m_ship, *m_terrain); }
  glm::dvec3 look() const { return m_rig.orientation() * glm::dvec3(0, 0, -1); }
  glm::dvec3 right() const { return m_rig.orientation() * glm::dvec3(1, 0, 0); }
  glm::dvec3 up() const { return m_rig.orientation() * glm::dvec3(0, 1, 0); }

  std::unique_ptr<TePatchDatabase> m_terrain = teNoGround();
  Ship m_ship;
  TeCameraRig m_rig;
};

TEST_F(TeCameraRigTest, FirstPersonTurnsAndRollsWithTheObject) {
  m_rig.setPerson(Person::First);
  ASSERT_TRUE(m_ship.setPosition({100, 200, 300}));
  follow();
  expectNear(m_rig.eye(), {100, 202, 301});
  expectNear(look(), {0, 1, 0});
  expectNear(up(), {0, 0, 1});
  ASSERT_TRUE(m_ship.setOrientation(turned(90, {0, 0, 1}) * turned(30, {0, 1, 0}))); // west, rolled right
  follow();
  expectNear(look(), {-1, 0, 0});
  expectNear(right(), {0, std::cos(M_PI / 6), -0.5});
  expectNear(m_rig.eye(), glm::dvec3(100, 200, 300) + m_ship.orientation() * glm::dvec3(0, 2, 1));
}

TEST_F(TeCameraRigTest, ThirdPersonFollowsTheHeadingAndNeverRolls) {
  m_rig.setPerson(Person::Third);
  ASSERT_TRUE(m_ship.setPosition({0, 0, 100}));
  for (const double heading : {0.0, 33.0, 90.0, 180.0, -90.0, 271.0})
    for (const double climb : {0.0, 40.0, -70.0})
      for (const double roll : {0.0, 60.0, -120.0}) {
        ASSERT_TRUE(m_ship.setOrientation(turned(heading, {0, 0, 1}) * turned(climb, {1, 0, 0}) *
                                          turned(roll, {0, 1, 0})));
        follow();
        const glm::dvec3 ahead(-std::sin(glm::radians(heading)), std::cos(glm::radians(heading)), 0);
        expectNear(m_rig.eye(), glm::dvec3(0, 0, 103) - 10.0 * ahead);
        EXPECT_NEAR(right().z, 0, 1e-12);
        EXPECT_GT(up().z, 0.9);
        EXPECT_GT(glm::dot(look(), ahead), 0.98);
        EXPECT_LT(look().z, 0) << "a little down";
      }
}

TEST_F(TeCameraRigTest, KeepsTheHeadingOfAnObjectThatLooksStraightUp) {
  m_rig.setPerson(Person::Third);
  ASSERT_TRUE(m_ship.setOrientation(turned(-90, {0, 0, 1})));
  follow();
  const glm::dquat before = m_rig.orientation();
  ASSERT_TRUE(m_ship.setOrientation(turned(-90, {0, 0, 1}) * turned(90, {1, 0, 0})));
  follow();
  EXPECT_EQ(m_rig.orientation(), before);
}

TEST_F(TeCameraRigTest, HeldKeysMoveItInTheObjectsFrame) {
  const struct {
    Key numpad;
    Key other;
    glm::dvec3 direction;
  } moves[] = {{Key::PAD_8, Key::I, {0, 1, 0}},   {Key::PAD_2, Key::K, {0, -1, 0}},
               {Key::PAD_4, Key::J, {-1, 0, 0}},  {Key::PAD_6, Key::L, {1, 0, 0}},
               {Key::PAGE_UP, Key::U, {0, 0, 1}}, {Key::PAGE_DOWN, Key::O, {0, 0, -1}}};
  for (const auto& move : moves)
    for (const Key key : {move.numpad, move.other}) {
      press(key);
      EXPECT_TRUE(m_rig.moving());
      for (int i = 0; i < 25; ++i)
        m_rig.update(0.01);
      release(key);
      EXPECT_FALSE(m_rig.moving());
      m_rig.update(1);
      expectNear(m_rig.moved(), move.direction * (0.25 * TeCameraRig::kSpeed));
      tap(Key::PAD_5);
      EXPECT_EQ(m_rig.moved(), glm::dvec3(0));
    }
  // East of an object that looks east is its front.
  ASSERT_TRUE(m_ship.setOrientation(turned(-90, {0, 0, 1})));
  press(Key::PAD_8);
  m_rig.update(0.2);
  follow();
  expectNear(m_rig.eye(), {-10 + 0.2 * TeCameraRig::kSpeed, 0, 3});
}

TEST_F(TeCameraRigTest, EveryPersonKeepsWhereItWasMoved) {
  m_rig.setPerson(Person::Third);
  press(Key::U);
  m_rig.update(0.5);
  release(Key::U);
  tap(Key::C);
  EXPECT_EQ(m_rig.person(), Person::First);
  EXPECT_EQ(m_rig.moved(), glm::dvec3(0));
  tap(Key::F2);
  EXPECT_EQ(m_rig.person(), Person::Third);
  expectNear(m_rig.moved(), {0, 0, 0.5 * TeCameraRig::kSpeed});
  tap(Key::HOME);
  EXPECT_EQ(m_rig.moved(), glm::dvec3(0));
}

TEST_F(TeCameraRigTest, CannotBeMovedOutOfSight) {
  press(Key::PAD_2);
  for (int i = 0; i < 300; ++i)
    m_rig.update(1);
  EXPECT_EQ(m_rig.moved(), glm::dvec3(0, -TeCameraRig::kLargestMove, 0));
  EXPECT_FALSE(m_rig.setMoved({0, 0, 2 * TeCameraRig::kLargestMove}));
  EXPECT_FALSE(m_rig.setMoved({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  EXPECT_TRUE(m_rig.setMoved({1, 2, 3}));
  EXPECT_EQ(m_rig.moved(), glm::dvec3(1, 2, 3));
}

TEST_F(TeCameraRigTest, KeysOfOthersAreLeftAlone) {
  for (const Key key : {Key::UP_ARROW, Key::LEFT_ARROW, Key::A, Key::W, Key::H, Key::P, Key::F1, Key::ESCAPE})
    EXPECT_FALSE(m_rig.handleEvent({key, true})) << key;
}

TEST_F(TeCameraRigTest, ThirdPersonStaysAboveKnownGround) {
  m_terrain = teTestGround([](std::int64_t, std::int64_t) { return 20.0f; });
  teBuildAround(*m_terrain, 1);
  ASSERT_TRUE(m_ship.setPosition({0, 0, 18}));
  m_rig.setPerson(Person::Third);
  follow();
  expectNear(m_rig.eye(), {0, -10, 20 + TeCameraRig::kEyeMargin});
  EXPECT_NEAR(m_rig.heightAboveGround(), TeCameraRig::kEyeMargin, 1e-9);
  m_rig.setPerson(Person::First);
  follow();
  EXPECT_NEAR(m_rig.eye().z, 19, 1e-9) << "first person is where the object has it";
  ASSERT_TRUE(m_ship.setPosition({1000, 0, 19}));
  follow();
  EXPECT_TRUE(std::isnan(m_rig.heightAboveGround())) << "nothing is known there";
}

TEST_F(TeCameraRigTest, TheCameraIsRelativeToAPointOfTheWorld) {
  SoDB::init();
  const TeNodePtr<SoPerspectiveCamera> camera(new SoPerspectiveCamera);
  ASSERT_TRUE(m_ship.setPosition({1e9 + 5, -1e9, 50}));
  follow();
  m_rig.apply(*camera, {1e9, -1e9, 0}, {0.5, 2048});
  EXPECT_EQ(camera->position.getValue(), SbVec3f(5, -10, 53));
  EXPECT_EQ(camera->nearDistance.getValue(), 0.5f);
  EXPECT_EQ(camera->farDistance.getValue(), 2048);
  SbVec3f forward;
  camera->orientation.getValue().multVec(SbVec3f(0, 0, -1), forward);
  EXPECT_NEAR(forward[1], look().y, 1e-6);
  EXPECT_NEAR(forward[2], look().z, 1e-6);
}

TEST_F(TeCameraRigTest, AnUnchangedViewNotifiesNobody) {
  SoDB::init();
  const TeNodePtr<SoPerspectiveCamera> camera(new SoPerspectiveCamera);
  follow();
  m_rig.apply(*camera, {0, 0, 0}, {0.5, 2048});
  int notified = 0;
  SoNodeSensor sensor([](void* data, SoSensor*) { ++*static_cast<int*>(data); }, &notified);
  sensor.setPriority(0);
  sensor.attach(camera.get());
  m_rig.apply(*camera, {0, 0, 0}, {0.5, 2048});
  EXPECT_EQ(notified, 0);
  m_rig.apply(*camera, {0, 0, 1}, {0.5, 2048});
  EXPECT_EQ(notified, 1);
}

TEST_F(TeCameraRigTest, AllThatDecidesTheViewIsInItsHash) {
  follow();
  const std::uint64_t before = m_rig.stateHash();
  follow();
  EXPECT_EQ(m_rig.stateHash(), before);
  press(Key::I);
  EXPECT_NE(m_rig.stateHash(), before) << "a held key";
  release(Key::I);
  EXPECT_EQ(m_rig.stateHash(), before);
  ASSERT_TRUE(m_rig.setMoved({0, 0, 1}));
  EXPECT_NE(m_rig.stateHash(), before);
  ASSERT_TRUE(m_rig.setMoved({0, 0, 0}));
  ASSERT_TRUE(m_ship.setOrientation(turned(1, {0, 0, 1})));
  follow();
  EXPECT_NE(m_rig.stateHash(), before) << "where the object looks";
}

} // namespace
