#pragma once

#include <glm/vec2.hpp>

/// A vector turned counter-clockwise by a small angle in radians, by a rational rotation: exactly a rotation,
/// by an angle that differs from the wanted one by less than its fifth power / 100; the same bits on every
/// machine.
inline glm::dvec2 teTurned(glm::dvec2 direction, double angle) {
  const double half = 0.5 * angle;
  const double t = half + half * half * half / 3; // the tangent's series
  const double scale = 1 / (1 + t * t);
  const double cosine = (1 - t * t) * scale;
  const double sine = 2 * t * scale;
  return {cosine * direction.x - sine * direction.y, sine * direction.x + cosine * direction.y};
}
