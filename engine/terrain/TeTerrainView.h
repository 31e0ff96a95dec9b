#pragma once

#include "engine/camera/TeViewFrustum.h"

#include <glm/vec3.hpp>

/// Who looks at the terrain from where.
struct TeTerrainView {
  glm::dvec3 position{0}; ///< of the active object
  glm::dvec3 velocity{0};
  TeViewFrustum frustum; ///< of the camera
};
