#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

class SoCamera;

/// Where an eye is and where it looks. The orientation turns Inventor's camera frame (x right, y up, looking
/// along -z) into the world's, where z is up.
struct TeViewPose {
  glm::dvec3 eye{0};
  glm::dquat orientation{1, 0, 0, 0};

  glm::dvec3 forward() const { return orientation * glm::dvec3(0, 0, -1); }
  glm::dvec3 up() const { return orientation * glm::dvec3(0, 1, 0); }

  /// Level with the horizon. `yaw` from east, counter-clockwise; `pitch` upwards; radians.
  static TeViewPose along(const glm::dvec3& eye, double yaw, double pitch);
  /// From one point to another; north up where that is straight up or down.
  static TeViewPose towards(const glm::dvec3& eye, const glm::dvec3& target);

  double yaw() const;
  double pitch() const;
  /// Writes place and orientation into a camera; only fields that differ.
  void apply(SoCamera& camera) const;

  friend bool operator==(const TeViewPose& a, const TeViewPose& b) {
    return a.eye == b.eye && a.orientation == b.orientation;
  }
};
