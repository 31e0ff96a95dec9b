#pragma once

#include <glm/vec2.hpp>

/// A unit vector turned counter-clockwise by an angle in radians, by a rational rotation: exactly a rotation,
/// by an angle that differs from the wanted one by less than its cube / 12; the same bits on every machine.
inline glm::dvec2 teTurned(glm::dvec2 direction, double angle) {
  const double t = 0.5 * angle;
  const double scale = 1 / (1 + t * t);
  const double cosine = (1 - t * t) * scale;
  const double sine = 2 * t * scale;
  return {cosine * direction.x - sine * direction.y, sine * direction.x + cosine * direction.y};
}
