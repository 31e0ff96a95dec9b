#include "engine/objects/TeDriveTrain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double kStep = 1.0 / 120;

/// Speed after some seconds on a slope given by its tangent, uphill positive.
double speedAfter(double seconds, double speed, const TeCarControls& controls, double slope) {
  const double upright = 1 / std::sqrt(1 + slope * slope);
  for (double time = 0; time < seconds; time += kStep)
    speed = TeDriveTrain::nextSpeed(speed, controls, slope * upright, upright, kStep);
  return speed;
}

TeCarControls pedal(double throttle) {
  TeCarControls controls;
  controls.throttle = throttle;
  return controls;
}

TEST(TeDriveTrain, TopSpeedIsWherePowerMeetsDrag) {
  const double top = speedAfter(120, 0, pedal(1), 0);
  EXPECT_NEAR(TeDriveTrain::kPower / top, TeDriveTrain::kDrag * top * top + TeDriveTrain::kRolling, 0.01);
  EXPECT_GT(top, 25);
  EXPECT_NEAR(speedAfter(60, 0, pedal(-1), 0), -TeDriveTrain::kReverseSpeed, 0.1);
}

TEST(TeDriveTrain, ClimbsUntilTheSlopeIsTooSteep) {
  EXPECT_GT(speedAfter(20, 0, pedal(1), 0.4), 8);
  EXPECT_EQ(speedAfter(20, 0, pedal(1), 0.75), 0) << "the brakes hold it";
  EXPECT_GE(speedAfter(20, 10, pedal(1), 0.75), -0.5);
  EXPECT_LE(speedAfter(20, 10, pedal(1), 0.75), 0) << "a run-up does not help for ever";
}

TEST(TeDriveTrain, LeftAloneItStopsOnAnySlopeThatTheTyresHold) {
  for (const double slope : {-0.8, -0.3, 0.0, 0.3, 0.8})
    for (const double speed : {20.0, -7.0})
      EXPECT_EQ(speedAfter(60, speed, TeCarControls(), slope), 0) << slope << " " << speed;
  EXPECT_EQ(speedAfter(10, 0, TeCarControls(), 0.8), 0);
  EXPECT_LT(speedAfter(10, 0, TeCarControls(), 1.1), -1) << "it slides";
}

TEST(TeDriveTrain, BrakesStopItFasterThanCoasting) {
  EXPECT_EQ(speedAfter(2.6, 20, pedal(-1), 0) > 0, false);
  EXPECT_GT(speedAfter(2.6, 20, pedal(0), 0), 10);
  TeCarControls handBrake;
  handBrake.handBrake = true;
  EXPECT_EQ(speedAfter(4, 20, handBrake, 0), 0);
  handBrake.throttle = 1;
  EXPECT_EQ(speedAfter(4, 0, handBrake, 0), 0);
}

// Any step, any speed: no overflow, no motion turned round by friction.
TEST(TeDriveTrain, HugeSpeedsAndStepsStayFinite) {
  for (const double speed : {1e3, 1e12, 1e300})
    for (const double dt : {1e-9, 0.1, 10.0}) {
      const double next = TeDriveTrain::nextSpeed(speed, pedal(-1), 0, 1, dt);
      EXPECT_TRUE(std::isfinite(next));
      EXPECT_GE(next, 0);
      EXPECT_LT(next, speed);
    }
}

} // namespace
