#pragma once

#include "generators/TeHeightMap.h"

#include <glm/vec3.hpp>

/// Land given by a formula, with exact normals: waves in turned directions, of wavelengths from 512 samples
/// down to 8, each as high as it is long in a fixed proportion.
class TeSmoothLand {
public:
  static constexpr double kSpacing = 10; ///< metres between samples

  double height(int column, int row) const;
  glm::dvec3 normal(int column, int row) const;
  TeHeightMap heights(int samples) const; ///< of one side
};

/// Mountains by midpoint displacement, 2^n + 1 samples a side, 10 m apart.
TeHeightMap teMountains(int samples);
