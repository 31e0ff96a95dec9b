#include "engine/objects/TeDriveTrain.h"

#include <algorithm>
#include <cmath>

namespace {

/// -1, 0 or 1.
double signOf(double x) { return double(x > 0) - double(x < 0); }

double engineAt(double speed, double throttle) {
  if (throttle * speed < 0 || (throttle < 0 && speed <= -TeDriveTrain::kReverseSpeed))
    return 0;
  const double fast = std::max(std::fabs(speed), 1e-3);
  return throttle * std::min(TeDriveTrain::kEngine, TeDriveTrain::kPower / fast);
}

double brakesAt(double speed, const TeCarControls& controls, double gravity) {
  double brakes = controls.handBrake ? TeDriveTrain::kHandBrake : 0;
  if (controls.throttle * speed < 0)
    brakes = std::max(brakes, TeDriveTrain::kBrake * std::fabs(controls.throttle));
  if (controls.throttle == 0)
    brakes = std::max(brakes, TeDriveTrain::kCoasting + std::max(0.0, gravity * signOf(speed)));
  return brakes;
}

} // namespace

double TeDriveTrain::nextSpeed(double speed, const TeCarControls& controls, double rise, double upright,
                               double dt) {
  const double grip = kGrip * kGravity * upright;
  const double gravity = -kGravity * rise;
  const double engine = controls.handBrake ? 0 : std::clamp(engineAt(speed, controls.throttle), -grip, grip);
  const double push = engine + gravity;
  if (speed == 0) {
    // The brakes hold, unless the engine overcomes the slope.
    const bool driven = engine * push > 0 && std::fabs(push) > kRolling;
    if (!driven && std::fabs(gravity) <= grip)
      return 0;
    const double held = driven ? kRolling : grip;
    return (push - signOf(push) * std::min(held, std::fabs(push))) * dt;
  }
  const double friction = std::min(brakesAt(speed, controls, gravity), grip) + kRolling;
  const double direction = signOf(speed);
  // Drag enters implicitly, so that no speed is too high for a step.
  const double next = (speed + (push - direction * friction) * dt) / (1 + kDrag * std::fabs(speed) * dt);
  // What stops it first is friction; what gravity and engine do then is up to the next step.
  return next * direction <= 0 ? 0 : next;
}
