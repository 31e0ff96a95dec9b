#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <array>

/// What a perspective camera sees, in world coordinates and double precision: four planes through the eye.
/// Its frame is that of Inventor's cameras: x right, y up, looking along -z.
class TeViewFrustum {
public:
  TeViewFrustum() = default; ///< sees everything
  /// `heightAngle`: radians, more than 0, below pi; `aspect`: width / height.
  TeViewFrustum(const glm::dvec3& eye, const glm::dquat& orientation, double heightAngle, double aspect);

  const glm::dvec3& eye() const { return m_eye; }
  glm::dvec3 direction() const { return m_direction; }
  /// False only if nothing of the box is seen; it may be true for some boxes near a corner that are not.
  bool meets(const glm::dvec3& minimum, const glm::dvec3& maximum) const;

private:
  glm::dvec3 m_eye{0};
  glm::dvec3 m_direction{0, 0, -1};
  std::array<glm::dvec3, 4> m_normals{}; ///< pointing inside
};
