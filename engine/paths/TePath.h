#pragma once

#include "engine/paths/TePathPoint.h"
#include "generators/base/TeResult.h"

#include <string>
#include <string_view>
#include <vector>

/// A way through the world: points joined by straight legs, and jumps. Immutable.
///
/// As text, one point a line:
///
///     # x y z [speed]: metres in the world, metres a second
///     0    0   120  40
///     0    900 +60        # 60 m above the ground; the speed as before
///     jump 1e6 0 +60      # at once
///     1e6  900 +60
///     repeat              # only at the end: goes on from here as if this were the first point
///
/// A path that repeats is moved so that its first point comes to lie on its last: one that ends where it
/// began is a loop, any other goes on for ever in the same way.
class TePath {
public:
  static constexpr std::size_t kMaxPoints = 100'000;
  static constexpr std::size_t kMaxBytes = 16'000'000; ///< of a file
  static constexpr double kMaxCoordinate = 4e15;       ///< metres
  static constexpr double kMinLeg = 1e-3;              ///< metres, except of a jump
  static constexpr double kMaxSpeed = 1e7;             ///< m/s

  /// Error, naming the point counted from 1: fewer than 2 or too many points; a coordinate or speed out of
  /// range; a leg that is too short, or that leads from an altitude to a height above ground or back (a jump
  /// may); a first point that is a jump; a loop of jumps alone.
  static TeResult<TePath> create(std::vector<TePathPoint> points, bool repeats = false);
  /// What keeps a point from following another one (null: it is the first); empty if nothing does.
  static std::string fault(const TePathPoint& point, const TePathPoint* before);
  /// Error: "NAME:LINE: reason". A point without speed keeps that of the point before.
  static TeResult<TePath> parse(std::string_view text, const std::string& name);
  /// Reads a text file. Error as for parse(), or the file cannot be read or is too large.
  static TeResult<TePath> read(const std::string& file);

  const std::vector<TePathPoint>& points() const { return m_points; }
  bool repeats() const { return m_repeats; }
  /// Point i, 1 .. points().size() - 1, is the end of leg i; metres, 0 for a jump.
  double legLength(std::size_t leg) const { return m_lengths[leg]; }
  /// Metres of all legs of one round.
  double length() const { return m_length; }
  /// What a round adds to all points of the next one.
  glm::dvec3 roundShift() const;

private:
  TePath() = default;

  std::vector<TePathPoint> m_points;
  std::vector<double> m_lengths; ///< [leg]
  double m_length = 0;
  bool m_repeats = false;
};
