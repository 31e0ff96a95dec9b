#include "apps/terrane-view/TeViewGround.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>

#include <algorithm>
#include <cmath>

std::optional<double> TeMapGround::heightAt(glm::dvec2 place) const {
  const double x = (place.x - m_corner.x) / m_spacing, y = (place.y - m_corner.y) / m_spacing;
  if (!(x >= 0 && y >= 0 && x <= m_map->width() - 1 && y <= m_map->height() - 1))
    return {};
  const int column = std::min(int(x), m_map->width() - 2), row = std::min(int(y), m_map->height() - 2);
  const double fx = x - column, fy = y - row;
  const float* south = m_map->row(row) + column;
  const float* north = m_map->row(row + 1) + column;
  const double height =
      (1 - fy) * ((1 - fx) * south[0] + fx * south[1]) + fy * ((1 - fx) * north[0] + fx * north[1]);
  if (std::isnan(height))
    return {};
  return m_corner.z + height * m_heightScale;
}

std::optional<double> TePickGround::heightAt(glm::dvec2 place) const {
  SoRayPickAction pick(SbViewportRegion(1, 1));
  pick.setRay(SbVec3f(float(place.x), float(place.y), float(m_top)), SbVec3f(0, 0, -1), 0, float(m_depth));
  pick.apply(m_scene.get());
  const SoPickedPoint* point = pick.getPickedPoint();
  return point ? std::optional<double>(point->getPoint()[2]) : std::nullopt;
}
