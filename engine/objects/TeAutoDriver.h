#pragma once

#include "engine/objects/TeCarControls.h"
#include "patchdb/TePatchDatabase.h"

#include <glm/vec2.hpp>

/// Drives a car without a human: a winding course at a steady speed, bent away from ground that is too steep,
/// and backing out where it cannot go on. The same situation always gives the same answer.
///
/// The course has a curvature that is a smooth function of the distance driven. From it, and from courses
/// bent to both sides of it, the one is taken whose ground, looked at kSeconds ahead, is the least steep and
/// that is bent the least.
class TeAutoDriver {
public:
  static constexpr double kSpeed = 14;    ///< m/s, the largest wanted
  static constexpr double kSeconds = 2;   ///< how far ahead it looks
  static constexpr double kComfort = 3.5; ///< m/s², the largest wanted towards the inside of a curve

  /// Where the car is.
  struct Situation {
    glm::dvec2 place{0};
    glm::dvec2 heading{0, 1}; ///< unit
    double speed = 0;         ///< m/s
    double limit = 0;         ///< largest curvature that can be steered now, 1/m
  };

  /// What to do for the next dt seconds.
  TeCarControls drive(const TePatchDatabase& terrain, const Situation& situation, double dt);
  std::uint64_t hash() const;

private:
  /// Steepest rise or fall on an arc ahead; unknown ground counts as kUnknown.
  double steepness(const TePatchDatabase& terrain, const Situation& situation, double curvature) const;
  TeCarControls backOut(double dt);

  double m_driven = 0;   ///< metres
  double m_stuck = 0;    ///< seconds that it has not come forward
  double m_backing = 0;  ///< seconds that it will still go back
  double m_steering = 0; ///< wanted last
};
