#pragma once

#include <glm/vec3.hpp>

/// A simple body in an object's own frame.
struct TeCollisionShape {
  enum class Kind { None, Sphere, Box };

  Kind kind = Kind::None;
  glm::dvec3 centre{0};
  glm::dvec3 halfExtents{0}; ///< metres; of a sphere: its radius three times
};
