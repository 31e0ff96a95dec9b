#pragma once

#include <glm/vec2.hpp>

/// A rectangle of the world, metres.
struct TeWorldRect {
  glm::dvec2 southWest{0};
  glm::dvec2 northEast{0};
};
