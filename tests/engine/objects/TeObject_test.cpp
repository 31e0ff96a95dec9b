#include "engine/objects/TeObject.h"

#include "engine/objects/TeTestGround.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(TeObject, RestsInTheMiddleOfTheWorldLookingNorth) {
  const TeObject object("tower");
  EXPECT_EQ(object.name(), "tower");
  EXPECT_EQ(object.position(), glm::dvec3(0));
  EXPECT_EQ(object.velocity(), glm::dvec3(0));
  EXPECT_EQ(object.orientation() * glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0));
  EXPECT_FALSE(object.moving());
}

TEST(TeObject, RefusesWhatIsNotFiniteAndStaysAsItWas) {
  TeObject object("tower");
  ASSERT_TRUE(object.setPosition({1, 2, 3}));
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(object.setPosition({0, bad, 0}).error().message, "tower: the position must be finite");
    EXPECT_EQ(object.setVelocity({0, 0, bad}).error().message, "tower: the velocity must be finite");
    EXPECT_FALSE(object.setOrientation({bad, 0, 0, 0}));
  }
  EXPECT_EQ(object.setOrientation({0, 0, 0, 0}).error().message,
            "tower: the orientation must be a finite rotation");
  EXPECT_EQ(object.position(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(object.velocity(), glm::dvec3(0));
  EXPECT_EQ(object.orientation(), glm::dquat(1, 0, 0, 0));
}

TEST(TeObject, NormalisesItsOrientation) {
  TeObject object("tower");
  ASSERT_TRUE(object.setOrientation({0, 0, 0, -4}));
  EXPECT_EQ(object.orientation(), glm::dquat(0, 0, 0, -1));
}

TEST(TeObject, MovesByItsVelocity) {
  TeObject object("drone");
  ASSERT_TRUE(object.setPosition({1e9, -5, 3}));
  ASSERT_TRUE(object.setVelocity({8, 16, -2}));
  EXPECT_TRUE(object.moving());
  object.update({0.25, 0.25, *teNoGround()});
  EXPECT_EQ(object.position(), glm::dvec3(1e9 + 2, -1, 2.5));
}

TEST(TeObject, EqualStatesHaveEqualHashesAndDifferentOnesDiffer) {
  TeObject object("drone");
  TeObject same("drone");
  EXPECT_EQ(object.stateHash(), same.stateHash());
  ASSERT_TRUE(same.setPosition({-0.0, 0, 0}));
  EXPECT_EQ(object.stateHash(), same.stateHash());
  EXPECT_NE(object.stateHash(), TeObject("other").stateHash());
  ASSERT_TRUE(same.setPosition({0, 0, 1e-300}));
  EXPECT_NE(object.stateHash(), same.stateHash());
  ASSERT_TRUE(same.setPosition({0, 0, 0}));
  ASSERT_TRUE(same.setVelocity({0, 1e-300, 0}));
  EXPECT_NE(object.stateHash(), same.stateHash());
  ASSERT_TRUE(same.setVelocity({0, 0, 0}));
  ASSERT_TRUE(same.setOrientation({0, 1, 0, 0}));
  EXPECT_NE(object.stateHash(), same.stateHash());
}

} // namespace
