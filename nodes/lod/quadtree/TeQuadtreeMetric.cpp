#include "nodes/lod/quadtree/TeQuadtreeMetric.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace {

constexpr double kRoundedUp = 1 + 1e-9;
/// Of the coordinates that a plane's distance is the difference of.
constexpr double kPlaneMargin = 1e-13;

} // namespace

TeQuadtreeMetric::TeQuadtreeMetric(const TeLodView& view, const TeLodField::Placement& placement, double side)
    : m_perspective(view.perspective), m_spacing(placement.spacing), m_heightScale(placement.heightScale),
      m_slack(view.slack), m_focal(view.focal * placement.heightScale) {
  m_x = (view.eye.x - placement.corner.x) / placement.spacing;
  m_y = (view.eye.y - placement.corner.y) / placement.spacing;
  m_z = view.eye.z - placement.corner.z;
  m_focal2 = m_focal * m_focal * kRoundedUp;
  m_planeCount = view.planeCount;
  for (int i = 0; i < m_planeCount; i++) {
    const glm::dvec4& plane = view.planes[std::size_t(i)];
    const double size = std::fabs(plane.w) + glm::length(placement.corner) + side * placement.spacing;
    m_planes[i] = {plane.x * m_spacing, plane.y * m_spacing, plane.z * m_heightScale,
                   glm::dot(glm::dvec3(plane), placement.corner) + plane.w + kPlaneMargin * size};
  }
}

double TeQuadtreeMetric::farthest(const TeQuadtreeBox& box) const {
  if (!m_perspective)
    return 1;
  const double x = std::max(box.x1 - m_x, m_x - box.x0) * m_spacing;
  const double y = std::max(box.y1 - m_y, m_y - box.y0) * m_spacing;
  const double z = std::max(box.z1 * m_heightScale - m_z, m_z - box.z0 * m_heightScale);
  return std::sqrt(x * x + y * y + z * z) + m_slack;
}

unsigned TeQuadtreeMetric::cut(const TeQuadtreeBox& box, unsigned planes) const {
  unsigned cutting = planes;
  const double morph = m_morph > 0 ? m_morph * farthest(box) : 0;
  for (int i = 0; i < m_planeCount; i++) {
    if ((planes >> i & 1) == 0)
      continue;
    const Plane& plane = m_planes[i];
    const bool x = plane.x > 0, y = plane.y > 0, z = plane.z > 0;
    const double off = std::fabs(plane.z) * morph;
    const double most = plane.x * (x ? box.x1 : box.x0) + plane.y * (y ? box.y1 : box.y0) +
                        plane.z * (z ? box.z1 : box.z0) + plane.w + off;
    if (most < 0)
      return kOutside;
    const double least = plane.x * (x ? box.x0 : box.x1) + plane.y * (y ? box.y0 : box.y1) +
                         plane.z * (z ? box.z0 : box.z1) + plane.w - off;
    if (least >= 0)
      cutting &= ~(1u << i);
  }
  return cutting;
}
