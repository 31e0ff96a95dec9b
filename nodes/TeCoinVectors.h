#pragma once

#include <Inventor/SbVec3d.h>
#include <Inventor/SbVec3f.h>

#include <glm/vec3.hpp>

/// Vectors of Coin as those of glm, and back.
inline glm::dvec3 teToGlm(const SbVec3f& vector) { return {vector[0], vector[1], vector[2]}; }
inline glm::dvec3 teToGlm(const SbVec3d& vector) { return {vector[0], vector[1], vector[2]}; }
inline SbVec3f teToCoin(const glm::dvec3& vector) {
  return {float(vector.x), float(vector.y), float(vector.z)};
}
