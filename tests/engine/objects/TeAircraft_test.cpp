#include "engine/objects/TeAircraft.h"

#include "engine/objects/TeObjects.h"
#include "engine/objects/TeTestGround.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using Key = SoKeyboardEvent::Key;
using testing::Contains;
using testing::HasSubstr;

class TeAircraftTest : public testing::Test {
protected:
  TeAircraftTest()
      : m_aircraft(static_cast<TeAircraft&>(**m_objects.add(std::make_unique<TeAircraft>("mine")))) {
    EXPECT_TRUE(m_aircraft.setPosition({0, 0, 200}));
  }
  void press(Key key) { EXPECT_TRUE(m_aircraft.handleEvent({key, true})); }
  void release(Key key) { EXPECT_TRUE(m_aircraft.handleEvent({key, false})); }
  void fly(double seconds, double dt = 1.0 / 64) {
    for (int i = 0; i < int(std::lround(seconds / dt)); ++i) {
      const auto tick = m_objects.update(dt, *m_terrain);
      ASSERT_TRUE(tick);
      ASSERT_TRUE(tick->errors.empty());
    }
  }
  glm::dvec3 up() const { return m_aircraft.orientation() * glm::dvec3(0, 0, 1); }
  glm::dvec3 right() const { return m_aircraft.orientation() * glm::dvec3(1, 0, 0); }

  std::unique_ptr<TePatchDatabase> m_terrain = teNoGround();
  TeObjects m_objects;
  TeAircraft& m_aircraft;
};

TEST_F(TeAircraftTest, RestsUntilAKeyIsPressed) {
  fly(0.5);
  EXPECT_FALSE(m_objects.anyAwake());
  EXPECT_EQ(m_aircraft.position(), glm::dvec3(0, 0, 200));
  press(Key::UP_ARROW);
  EXPECT_TRUE(m_objects.anyAwake());
  fly(1);
  release(Key::UP_ARROW);
  EXPECT_NEAR(m_aircraft.velocity().y, TeAircraft::kAcceleration, 1e-9);
  EXPECT_NEAR(m_aircraft.position().y, 0.5 * TeAircraft::kAcceleration, 1e-9);
}

TEST_F(TeAircraftTest, FliesOnAtTheVelocityThatItIsGiven) {
  ASSERT_TRUE(m_aircraft.setVelocity({30, 40, 0}));
  fly(8);
  EXPECT_EQ(m_aircraft.velocity(), glm::dvec3(30, 40, 0));
  EXPECT_EQ(m_aircraft.position(), glm::dvec3(240, 320, 200));
  const glm::dvec3 nose = m_aircraft.orientation() * glm::dvec3(0, 1, 0);
  EXPECT_NEAR(nose.x, 0.6, 1e-12);
  EXPECT_NEAR(nose.y, 0.8, 1e-12);
}

TEST_F(TeAircraftTest, SlowsToAStandstillNotBackwards) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 20, 0}));
  press(Key::DOWN_ARROW);
  fly(5);
  EXPECT_EQ(m_aircraft.speed(), 0);
  release(Key::DOWN_ARROW);
  fly(1);
  EXPECT_FALSE(m_objects.anyAwake());
  EXPECT_EQ(m_aircraft.forward(), glm::dvec3(0, 1, 0)) << "it still looks ahead";
}

TEST_F(TeAircraftTest, KeysDoNotMakeItFasterThanTheFastest) {
  press(Key::R);
  fly(60);
  EXPECT_NEAR(m_aircraft.speed(), TeAircraft::kFastest, 1e-9);
  release(Key::R);
  ASSERT_TRUE(m_aircraft.setVelocity({0, 600, 0}));
  press(Key::A);
  fly(1);
  EXPECT_NEAR(m_aircraft.speed(), 600, 1e-9) << "what was set stays";
}

TEST_F(TeAircraftTest, TurnsAtItsRateWhateverTheFrameRate) {
  for (const double dt : {1.0 / 512, 1.0 / 64, 1.0 / 16, 0.5}) {
    ASSERT_TRUE(m_aircraft.setPosition({0, 0, 200}));
    ASSERT_TRUE(m_aircraft.setVelocity({0, 50, 0}));
    press(Key::RIGHT_ARROW);
    fly(2, dt);
    release(Key::RIGHT_ARROW);
    const double angle = 2 * TeAircraft::kTurnRate;
    EXPECT_NEAR(m_aircraft.velocity().x, 50 * std::sin(angle), 1e-5) << dt;
    EXPECT_NEAR(m_aircraft.velocity().y, 50 * std::cos(angle), 1e-5) << dt;
    const double radius = 50 / TeAircraft::kTurnRate;
    EXPECT_NEAR(m_aircraft.position().x, radius * (1 - std::cos(angle)), 0.02) << dt;
    EXPECT_NEAR(m_aircraft.position().y, radius * std::sin(angle), 0.02) << dt;
  }
}

TEST_F(TeAircraftTest, BanksIntoTheTurnAndLevelsAfterIt) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 50, 0}));
  press(Key::D); // to the right
  fly(2);
  EXPECT_LT(right().z, -0.5) << "the right wing is down";
  EXPECT_GT(up().z, 0.5) << "at most about 50°";
  release(Key::D);
  fly(3);
  EXPECT_EQ(right().z, 0);
  press(Key::LEFT_ARROW);
  fly(1);
  EXPECT_GT(right().z, 0.3);
}

TEST_F(TeAircraftTest, ClimbsAsLongAsTheKeyIsHeldThenLevels) {
  ASSERT_TRUE(m_aircraft.setVelocity({40, 0, 0}));
  press(Key::E);
  fly(0.5);
  EXPECT_NEAR(m_aircraft.forward().z / m_aircraft.forward().x, 0.5 * TeAircraft::kClimbRate, 1e-9);
  const glm::dvec3 nose = m_aircraft.orientation() * glm::dvec3(0, 1, 0);
  EXPECT_NEAR(nose.z, m_aircraft.forward().z, 1e-9) << "the nose follows the climb";
  fly(5);
  EXPECT_NEAR(m_aircraft.forward().z / m_aircraft.forward().x, TeAircraft::kSteepest, 1e-9);
  release(Key::E);
  fly(2);
  EXPECT_EQ(m_aircraft.velocity().z, 0);
  EXPECT_NEAR(m_aircraft.speed(), 40, 1e-9);
  EXPECT_GT(m_aircraft.position().z, 300);
  press(Key::Q);
  fly(0.25);
  EXPECT_LT(m_aircraft.velocity().z, -5);
}

TEST_F(TeAircraftTest, AClimbThatWasSetGoesOn) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 40, 8}));
  fly(2);
  EXPECT_EQ(m_aircraft.velocity(), glm::dvec3(0, 40, 8));
}

TEST_F(TeAircraftTest, FliesStraightUpWithoutLosingItsOrientation) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 0, 30}));
  fly(1);
  EXPECT_EQ(m_aircraft.position(), glm::dvec3(0, 0, 230));
  EXPECT_NEAR(glm::length(m_aircraft.orientation()), 1, 1e-12);
  press(Key::LEFT_ARROW);
  press(Key::E);
  fly(1);
  EXPECT_TRUE(std::isfinite(m_aircraft.position().x));
}

TEST_F(TeAircraftTest, StaysClearOfKnownGround) {
  m_terrain = teTestGround([](std::int64_t x, std::int64_t y) { return float((x * 7 + y * 3) % 11); });
  teBuildAround(*m_terrain, 3);
  ASSERT_TRUE(m_aircraft.setPosition({-40, -40, 15}));
  ASSERT_TRUE(m_aircraft.setVelocity({15, 15, -6}));
  double least = 1e9;
  for (int i = 0; i < 300; ++i) {
    fly(1.0 / 64);
    const glm::dvec3& p = m_aircraft.position();
    if (const auto ground = m_terrain->heightAt({p.x, p.y}))
      least = std::min(least, p.z - *ground);
  }
  EXPECT_GE(least, TeAircraft::kClearance - 1e-9);
  EXPECT_LT(least, TeAircraft::kClearance + 1e-9) << "it did come down";
  EXPECT_GE(m_aircraft.velocity().z, 0) << "the dive ended at the ground";
  EXPECT_NEAR(m_aircraft.speed(), std::sqrt(15 * 15 * 2 + 36), 1e-9);
}

TEST_F(TeAircraftTest, APilotFliesInPlaceOfTheKeys) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 40, 0}));
  press(Key::LEFT_ARROW);
  m_aircraft.setPilot([](const TeAircraft&, const TeUpdate&) { return TeAircraft::Steering{0, 5, 0}; });
  fly(1);
  EXPECT_NEAR(m_aircraft.velocity().x, 40 * std::sin(TeAircraft::kTurnRate), 1e-6) << "never more than all";
  m_aircraft.setPilot(nullptr);
  fly(1);
  EXPECT_NEAR(m_aircraft.velocity().x, 0, 1e-6) << "the key was held all the time";
}

TEST_F(TeAircraftTest, KeysOfOthersAreLeftAlone) {
  for (const Key key :
       {Key::W, Key::H, Key::P, Key::C, Key::PAD_8, Key::PAGE_UP, Key::F1, Key::ESCAPE, Key::I})
    EXPECT_FALSE(m_aircraft.handleEvent({key, true})) << key;
}

TEST_F(TeAircraftTest, ForgetsKeysWhenTold) {
  press(Key::UP_ARROW);
  m_aircraft.releaseKeys();
  fly(1);
  EXPECT_EQ(m_aircraft.speed(), 0);
  EXPECT_FALSE(m_objects.anyAwake());
}

TEST_F(TeAircraftTest, PointsWhereItIsTold) {
  ASSERT_TRUE(m_aircraft.setVelocity({0, 30, 0}));
  ASSERT_TRUE(m_aircraft.setHeading(-2, 0));
  EXPECT_EQ(m_aircraft.velocity(), glm::dvec3(-30, 0, 0));
  EXPECT_NEAR((m_aircraft.orientation() * glm::dvec3(0, 1, 0)).x, -1, 1e-12);
  EXPECT_FALSE(m_aircraft.setHeading(0, 0));
  EXPECT_FALSE(m_aircraft.setHeading(std::nan(""), 1));
}

TEST_F(TeAircraftTest, TellsSpeedHeadingAndClimb) {
  ASSERT_TRUE(m_aircraft.setVelocity({-25, 0, 2}));
  const std::vector<std::string> lines = m_aircraft.hudLines();
  EXPECT_THAT(lines, Contains(HasSubstr("25.1 m/s")));
  EXPECT_THAT(lines, Contains(HasSubstr("270.0°")));
  EXPECT_THAT(lines, Contains(HasSubstr("+2.0 m/s")));
  EXPECT_FALSE(m_aircraft.helpLines().empty());
}

TEST_F(TeAircraftTest, AllThatDecidesWhatItDoesIsInItsHash) {
  TeAircraft same("mine");
  ASSERT_TRUE(same.setPosition({0, 0, 200}));
  EXPECT_EQ(m_aircraft.stateHash(), same.stateHash());
  EXPECT_TRUE(same.handleEvent({Key::E, true}));
  EXPECT_NE(m_aircraft.stateHash(), same.stateHash()) << "a key that is held";
  EXPECT_TRUE(same.handleEvent({Key::E, false}));
  ASSERT_TRUE(same.setHeading(1, 0));
  EXPECT_NE(m_aircraft.stateHash(), same.stateHash()) << "where it points at rest";
}

TEST_F(TeAircraftTest, ItsModelsAgree) {
  SoDB::init();
  const TeNodePtr<SoNode> model(m_aircraft.drawModel());
  ASSERT_TRUE(model);
  SoGetBoundingBoxAction bounds(SbViewportRegion(100, 100));
  bounds.apply(model.get());
  const SbBox3f drawn = bounds.getBoundingBox();
  const TeCollisionShape shape = m_aircraft.collisionShape();
  ASSERT_EQ(shape.kind, TeCollisionShape::Kind::Box);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(drawn.getMin()[i], shape.centre[i] - shape.halfExtents[i], 0.1) << i;
    EXPECT_NEAR(drawn.getMax()[i], shape.centre[i] + shape.halfExtents[i], 0.1) << i;
  }
  EXPECT_GT(shape.centre.z - shape.halfExtents.z, -TeAircraft::kClearance)
      << "its body stays above the ground, too";
}

} // namespace
