#include "nodes/lod/drawing/TeLodRays.h"

#include "nodes/TeCoinVectors.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kMargin = 1e-6; ///< of what is added in single precision

double inside(const glm::dvec4& plane, const glm::dvec3& point) {
  return glm::dot(glm::dvec3(plane), point) + plane.w;
}

/// Twice the area of (a, b, p): negative if p is to the right of a-b.
double side(const TeLodVertex& a, const TeLodVertex& b, const glm::dvec3& p) {
  return (double(b.column) - a.column) * (p.y - a.row) - (p.x - a.column) * (double(b.row) - a.row);
}

} // namespace

TeLodRays::TeLodRays(SoNode& node, SoRayPickAction& action, TeLodViewers& viewers, const glm::dvec3& origin)
    : m_node(node), m_action(action), m_viewers(viewers), m_origin(origin), m_line(action.getLine()),
      m_start(teToGlm(m_line.getPosition())), m_ahead(glm::normalize(teToGlm(m_line.getDirection()))) {
  const glm::dvec3 other = std::abs(m_ahead.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  m_across = glm::normalize(glm::cross(m_ahead, other));
  m_up = glm::cross(m_ahead, m_across);
  const SbBox3f box = viewers.box();
  m_margin = kMargin * (glm::length(m_start) + double((box.getMax() - box.getMin()).length()));
}

void TeLodRays::pick() {
  const std::optional<TeLodView> view = m_viewers.view(m_action.getState());
  if (!view)
    return;
  std::vector<Hit> drawn, others;
  m_viewers.forEachPart(&m_action, [&](const TeLodMesh& part) { findHits(part, drawn); });
  if (!staysInView(*view))
    m_viewers.forEachPartAlong(m_line, [&](const TeLodMesh& part) { findHits(part, others); });
  if (!others.empty())
    m_viewers.forEachPart(&m_action, [&](const TeLodMesh& part) { cover(part, others); });
  bool meets = !drawn.empty();
  for (const Hit& hit : drawn)
    add(hit);
  for (const Hit& hit : others) {
    if (hit.isCovered)
      continue;
    add(hit);
    meets = true;
  }
  // Between two surfaces that do not meet where drawing ends.
  for (std::size_t i = 0; i < others.size() && !meets; i++)
    add(others[i]);
}

bool TeLodRays::staysInView(const TeLodView& view) const {
  for (int i = 0; i < view.planeCount; i++) {
    const glm::dvec4& plane = view.planes[std::size_t(i)];
    const double first = inside(plane, m_start);
    const double slope = glm::dot(glm::dvec3(plane), m_ahead);
    if (first < -m_margin)
      return false;
    if (slope >= -kMargin)
      continue;
    // It leaves through this plane: is what is beyond cut off?
    const double leaves = first / -slope + 2 * m_margin / -slope;
    if (m_action.isBetweenPlanes(teToCoin(m_start + leaves * m_ahead)))
      return false;
  }
  return true;
}

void TeLodRays::place(const TeLodMesh& part) {
  const TeLodScene& scene = m_viewers.scene();
  m_points.clear();
  m_sides.clear();
  for (const TeLodVertex& vertex : part.vertices) {
    const glm::dvec3 position = scene.field->position(vertex) + scene.offset;
    m_points.push_back(teToCoin(position));
    m_sides.push_back({glm::dot(m_across, position - m_start), glm::dot(m_up, position - m_start)});
  }
}

bool TeLodRays::mayMeet(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Side& p = m_sides[a];
  const Side& q = m_sides[b];
  const Side& r = m_sides[c];
  return std::min({p.across, q.across, r.across}) <= m_margin &&
         std::max({p.across, q.across, r.across}) >= -m_margin && std::min({p.up, q.up, r.up}) <= m_margin &&
         std::max({p.up, q.up, r.up}) >= -m_margin;
}

void TeLodRays::findHits(const TeLodMesh& part, std::vector<Hit>& hits) {
  place(part);
  for (const std::vector<std::uint32_t>* indices : {&part.indices, &part.skirts})
    for (std::size_t i = 0; i + 2 < indices->size(); i += 3) {
      const std::uint32_t* corner = &(*indices)[i];
      if (!mayMeet(corner[0], corner[1], corner[2]))
        continue;
      const SbVec3f &a = m_points[corner[0]], &b = m_points[corner[1]], &c = m_points[corner[2]];
      SbVec3f point, barycentric;
      SbBool isFront;
      if (m_action.intersect(a, b, c, point, barycentric, isFront) && m_action.isBetweenPlanes(point))
        hits.push_back({point, {a, b, c}, false});
    }
}

glm::dvec3 TeLodRays::samples(const SbVec3f& point) const {
  const TeLodScene& scene = m_viewers.scene();
  return (teToGlm(point) - scene.offset - scene.field->placement().corner) / scene.field->spacing();
}

void TeLodRays::cover(const TeLodMesh& part, std::vector<Hit>& hits) const {
  for (Hit& hit : hits) {
    const glm::dvec3 point = samples(hit.point);
    for (std::size_t i = 0; i + 2 < part.indices.size() && !hit.isCovered; i += 3) {
      const TeLodVertex& a = part.vertices[part.indices[i]];
      const TeLodVertex& b = part.vertices[part.indices[i + 1]];
      const TeLodVertex& c = part.vertices[part.indices[i + 2]];
      hit.isCovered = side(a, b, point) >= 0 && side(b, c, point) >= 0 && side(c, a, point) >= 0;
    }
  }
}

void TeLodRays::add(const Hit& hit) {
  SoPickedPoint* picked = m_action.addIntersection(hit.point);
  if (!picked)
    return;
  SbVec3f normal = (hit.corners[1] - hit.corners[0]).cross(hit.corners[2] - hit.corners[0]);
  normal.normalize();
  picked->setObjectNormal(normal);
  const glm::dvec3 cell = glm::floor(samples(hit.point));
  TeRayHit detail;
  detail.distance = double((hit.point - m_line.getPosition()).length());
  detail.position = m_origin + teToGlm(hit.point);
  detail.normal = teToGlm(normal);
  detail.key = {std::int64_t(cell.x), std::int64_t(cell.y), 0};
  picked->setDetail(new SoTeTerrainDetail(detail), &m_node);
}
