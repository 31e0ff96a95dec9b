#pragma once

#include "patchdb/TePatchKey.h"

#include <glm/vec3.hpp>

/// Where a ray meets the surface.
struct TeRayHit {
  double distance = 0; ///< along the ray, in units of its direction
  glm::dvec3 position{0};
  glm::dvec3 normal{0}; ///< unit, of the triangle; z > 0 also where the ray comes from below
  TePatchKey key;
};
