#pragma once

#include "nodes/lod/TeLodView.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>

/// A box of terrain as a tree of boxes is asked for it: seen or not, and how far away. Metres.
struct TeLodBox {
  glm::dvec3 low{0};
  glm::dvec3 high{0};

  /// One bit for each plane of a view: those that the root is to be tried against.
  static unsigned allPlanes(const TeLodView& view) { return (1u << view.planeCount) - 1; }

  /// TeLodView::meets() by the planes in `planes` only; takes those away that the box lies wholly within, so
  /// that they are not tried for what it contains.
  bool isSeen(const TeLodView& view, unsigned& planes) const {
    for (int i = 0; i < view.planeCount; i++) {
      if (!(planes >> i & 1u))
        continue;
      const glm::dvec4& plane = view.planes[std::size_t(i)];
      const glm::dvec3 farthest(plane.x > 0 ? high.x : low.x, plane.y > 0 ? high.y : low.y,
                                plane.z > 0 ? high.z : low.z);
      if (glm::dot(glm::dvec3(plane), farthest) + plane.w < 0)
        return false;
      const glm::dvec3 nearest(plane.x > 0 ? low.x : high.x, plane.y > 0 ? low.y : high.y,
                               plane.z > 0 ? low.z : high.z);
      if (glm::dot(glm::dvec3(plane), nearest) + plane.w > 0)
        planes &= ~(1u << i);
    }
    return true;
  }

  /// From the nearest place where the true eye may be; 0 inside.
  double distance(const TeLodView& view) const {
    const glm::dvec3 beside = glm::max(glm::max(low - view.eye, view.eye - high), glm::dvec3(0));
    return std::max(0.0, glm::length(beside) - view.slack);
  }
};

/// The largest vertical deviation, in the unit of the samples, that shows as no more than so many pixels at a
/// distance: a hair less, so that TeLodView::pixels() of it is not above.
inline double teLargestDeviation(const TeLodView& view, double pixels, double distance, double heightScale) {
  const double metres = view.perspective ? pixels * distance / view.focal : pixels / view.focal;
  return heightScale > 0 ? metres / heightScale * (1 - 0x1p-50) : std::numeric_limits<double>::infinity();
}
