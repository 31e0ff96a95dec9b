#pragma once

#include "engine/objects/TeCarControls.h"

/// A car's motion along its own forward axis: what engine, brakes, resistance and gravity make of its speed.
/// SI units; accelerations are forces for each kilogram.
///
///     engine   throttle · min(kEngine, kPower / |v|), in reverse up to kReverseSpeed
///     gravity  -g · sin(pitch)
///     brakes   against the motion: kBrake, the hand brake kHandBrake; with no pedal pressed as much as makes
///              the car slower by kCoasting whatever the slope
///     drag     kDrag · v², and kRolling
///
/// Engine and brakes reach no farther than the tyres hold: kGrip · g · up.z. A resting car stays at rest as
/// long as no engine moves it and the tyres hold it on the slope.
struct TeDriveTrain {
  static constexpr double kGravity = 9.80665;
  static constexpr double kEngine = 5.5;
  static constexpr double kPower = 70;
  static constexpr double kReverseSpeed = 8;
  static constexpr double kBrake = 8;
  static constexpr double kHandBrake = 6;
  static constexpr double kCoasting = 1.2;
  static constexpr double kDrag = 0.0018; ///< 1/m; top speed about 34 m/s
  static constexpr double kRolling = 0.15;
  static constexpr double kGrip = 0.95;

  /// The speed after dt seconds, negative in reverse. `rise`: z of the body's forward axis, `upright`: z of
  /// its up. Friction alone never turns the motion round: it ends at exactly 0.
  static double nextSpeed(double speed, const TeCarControls& controls, double rise, double upright,
                          double dt);
};
