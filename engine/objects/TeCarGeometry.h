#pragma once

#include <glm/vec3.hpp>

#include <array>

/// A car's measures, metres. Its frame: x right, y forward, z up; the origin lies on the ground in the middle
/// between the wheels.
struct TeCarGeometry {
  enum Wheel { FrontLeft, FrontRight, RearLeft, RearRight };
  static constexpr int kWheels = 4;

  static constexpr double kWheelbase = 2.6; ///< between the axles
  static constexpr double kTrack = 1.6;     ///< between left and right wheels, of their middle planes
  static constexpr double kWheelRadius = 0.36;
  static constexpr double kWheelWidth = 0.26;
  /// How far the suspension lets a wheel move from its middle position, up and down.
  static constexpr double kTravel = 0.35;
  /// Steepest ground that the car drives onto, rise over run; anything steeper is a wall or a precipice to
  /// it.
  static constexpr double kSteepest = 1.2;
  /// Tangent of the largest angle of the front wheels (of one in the middle between them).
  static constexpr double kSteering = 0.65;

  /// Where a wheel's tyre touches flat ground.
  static constexpr glm::dvec3 wheel(int wheel) {
    return {wheel % 2 == 0 ? -0.5 * kTrack : 0.5 * kTrack,
            wheel < RearLeft ? 0.5 * kWheelbase : -0.5 * kWheelbase, 0};
  }
};
