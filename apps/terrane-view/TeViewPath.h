#pragma once

#include "apps/terrane-view/TeViewGround.h"
#include "apps/terrane-view/TeViewPose.h"
#include "engine/paths/TePathTraveller.h"

#include <string>
#include <vector>

/// An eye that travels a path, looking where it goes and somewhat down. At heights above ground it follows
/// the ground as a damped spring does, and never comes nearer to it than half of that height.
class TeViewPath {
public:
  static constexpr double kStiffness = 1.5; ///< radians a second
  static constexpr double kTurning = 3;     ///< of the direction towards the path's, a second
  static constexpr double kPitch = -0.2;    ///< radians

  /// `ground` may be null, then heights above it are altitudes; else it outlives the eye.
  TeViewPath(TePathTraveller traveller, const TeViewGround* ground);

  /// Of the built-in paths that lead over a bounded terrain.
  static const std::vector<std::string>& names();
  /// A built-in path, as large as suits a terrain of this side around its middle, or one from a file. `speed`
  /// 0 means that of the file, and a side in 60 s. Error: no such path.
  static TeResult<TeViewPath> create(const std::string& path, const glm::dvec3& middle, double side,
                                     double altitude, double speed, const TeViewGround* ground);

  const TeViewPose& pose() const { return m_pose; }
  const TePathTraveller& traveller() const { return m_traveller; }
  /// Seconds, finite and not negative.
  void update(double dt);

private:
  double ground() const;
  void arrive();

  TePathTraveller m_traveller;
  const TeViewGround* m_ground;
  double m_altitude = 0;
  double m_climb = 0;
  double m_yaw = 0;
  TeViewPose m_pose;
};
