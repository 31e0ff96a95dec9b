#include "apps/terrane-view/TeViewPose.h"

#include <Inventor/nodes/SoCamera.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kHalfTurn = 0.70710678118654752; ///< cosine and sine of half of 90°
constexpr double kQuarter = 1.57079632679489662;

} // namespace

TeViewPose TeViewPose::along(const glm::dvec3& eye, double yaw, double pitch) {
  // From a camera that looks north with z up: turned about x by the pitch, then about z.
  const glm::dquat level(kHalfTurn, kHalfTurn, 0, 0);
  const glm::dquat raised(std::cos(pitch / 2), std::sin(pitch / 2), 0, 0);
  const double turn = (yaw - kQuarter) / 2;
  const glm::dquat turned(std::cos(turn), 0, 0, std::sin(turn));
  return {eye, glm::normalize(turned * raised * level)};
}

TeViewPose TeViewPose::towards(const glm::dvec3& eye, const glm::dvec3& target) {
  const glm::dvec3 way = target - eye;
  const double level = std::hypot(way.x, way.y);
  const double yaw = level > 0 ? std::atan2(way.y, way.x) : kQuarter;
  return along(eye, yaw, std::atan2(way.z, level));
}

double TeViewPose::yaw() const {
  // Straight up or down, the picture's upper edge tells.
  const glm::dvec3 ahead = forward();
  const glm::dvec3 way = std::hypot(ahead.x, ahead.y) > 1e-6 ? ahead : up() * (ahead.z > 0 ? -1.0 : 1.0);
  return std::atan2(way.y, way.x);
}

double TeViewPose::pitch() const { return std::asin(std::clamp(forward().z, -1.0, 1.0)); }

void TeViewPose::apply(SoCamera& camera) const {
  const SbVec3f position(float(eye.x), float(eye.y), float(eye.z));
  if (camera.position.getValue() != position)
    camera.position = position;
  const SbRotation rotation(float(orientation.x), float(orientation.y), float(orientation.z),
                            float(orientation.w));
  if (camera.orientation.getValue() != rotation)
    camera.orientation = rotation;
}
