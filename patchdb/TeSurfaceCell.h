#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

/// One cell of the surface: four corner heights, split along the SW-NE diagonal (contract 4). Local
/// coordinates u, v are in [0, 1] from the south-west corner.
struct TeSurfaceCell {
  float southWest = 0;
  float southEast = 0;
  float northWest = 0;
  float northEast = 0;

  /// The cell whose south-west corner is the given sample of a grid.
  static TeSurfaceCell of(const float* sample, int stride) {
    return {sample[0], sample[1], sample[stride], sample[stride + 1]};
  }

  /// A cell with a missing corner is not part of the surface.
  bool complete() const {
    return !(std::isnan(southWest) || std::isnan(southEast) || std::isnan(northWest) ||
             std::isnan(northEast));
  }

  float lowest() const { return std::min(std::min(southWest, southEast), std::min(northWest, northEast)); }
  float highest() const { return std::max(std::max(southWest, southEast), std::max(northWest, northEast)); }

  /// Height at a point; at the corners exactly the corner's float.
  double height(double u, double v) const;
  /// Unit normal of the triangle that holds the point; on the diagonal, of the southern one.
  glm::dvec3 normal(double u, double v, double spacing) const;
  /// The largest distance in height between this surface and the cell split along the other diagonal, or the
  /// bilinear patch: |southWest + northEast - southEast - northWest| / 2, reached in the middle by the other
  /// diagonal.
  double deviation() const;
};
