#include "nodes/lod/TeLodView.h"

#include <glm/geometric.hpp>

#include <limits>

double TeLodView::pixels(double deviation, double distance) const {
  if (deviation == 0)
    return 0;
  if (!perspective)
    return deviation * focal;
  return distance > 0 ? deviation * focal / distance : std::numeric_limits<double>::infinity();
}

bool TeLodView::meets(const glm::dvec3& low, const glm::dvec3& high) const {
  for (int i = 0; i < planeCount; i++) {
    const glm::dvec4& plane = planes[std::size_t(i)];
    const glm::dvec3 farthest(plane.x > 0 ? high.x : low.x, plane.y > 0 ? high.y : low.y,
                              plane.z > 0 ? high.z : low.z);
    if (glm::dot(glm::dvec3(plane), farthest) + plane.w < 0)
      return false;
  }
  return true;
}
