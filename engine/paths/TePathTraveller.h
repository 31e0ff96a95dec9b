#pragma once

#include "engine/paths/TePath.h"

/// Someone who moves along a path: where they are is a function of the path, the speeds and the time passed,
/// however it is cut into steps (up to rounding).
class TePathTraveller {
public:
  /// `speed`: m/s where the path says none; more than 0, at most TePath::kMaxSpeed. `always`: also where it
  /// says one.
  TePathTraveller(TePath path, double speed, bool always = false);

  const TePath& path() const { return m_path; }
  /// Moves on for so many seconds, finite and not negative. Cost: the points passed, at most one round.
  void advance(double seconds);
  /// At the end of a path that does not repeat; it stays there.
  bool ended() const { return m_ended; }

  /// z is an altitude or a height above ground.
  glm::dvec3 place() const;
  bool aboveGround() const { return m_path.points()[m_leg].aboveGround; }
  /// Of the leg; unit.
  glm::dvec3 direction() const;
  double speed() const; ///< m/s now; 0 once ended
  /// Metres travelled, jumps not counted.
  double distance() const { return m_distance; }
  std::int64_t jumps() const { return m_jumps; } ///< so far

private:
  double speedOf(std::size_t leg) const;
  double secondsOf(std::size_t leg) const;
  /// False at the end of the path.
  bool nextLeg();
  void skipRounds(double& seconds);

  TePath m_path;
  double m_speed;
  bool m_always;
  double m_roundSeconds = 0;
  std::size_t m_leg = 1; ///< it leads to the point of this number
  double m_along = 0;    ///< metres
  glm::dvec3 m_shift{0}; ///< of the present round
  double m_distance = 0;
  std::int64_t m_jumps = 0;
  bool m_ended = false;
};
