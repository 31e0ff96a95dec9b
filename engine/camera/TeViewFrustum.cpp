#include "engine/camera/TeViewFrustum.h"

#include <glm/geometric.hpp>

#include <cmath>

TeViewFrustum::TeViewFrustum(const glm::dvec3& eye, const glm::dquat& orientation, double heightAngle,
                             double aspect)
    : m_eye(eye), m_direction(orientation * glm::dvec3(0, 0, -1)) {
  const double up = std::tan(heightAngle / 2);
  const double right = up * aspect;
  // Of the planes |x| = -right·z and |y| = -up·z.
  m_normals = {orientation * glm::dvec3(-1, 0, -right), orientation * glm::dvec3(1, 0, -right),
               orientation * glm::dvec3(0, -1, -up), orientation * glm::dvec3(0, 1, -up)};
}

bool TeViewFrustum::meets(const glm::dvec3& minimum, const glm::dvec3& maximum) const {
  for (const glm::dvec3& normal : m_normals) {
    const glm::dvec3 farthest{normal.x > 0 ? maximum.x : minimum.x, normal.y > 0 ? maximum.y : minimum.y,
                              normal.z > 0 ? maximum.z : minimum.z};
    if (glm::dot(farthest - m_eye, normal) < 0)
      return false;
  }
  return true;
}
