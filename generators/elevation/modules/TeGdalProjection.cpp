#include "generators/elevation/modules/TeGdalProjection.h"

#include "generators/elevation/modules/TeGdalErrors.h"

#include <cmath>

TeGdalProjection::TeGdalProjection(const OGRSpatialReference& system) : m_system(system) {
  const TeGdalErrors errors;
  m_system.StripVertical();
  m_system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
}

std::shared_ptr<const TeMapProjection> TeGdalProjection::degrees() {
  const TeGdalErrors errors;
  OGRSpatialReference wgs84;
  if (wgs84.SetWellKnownGeogCS("WGS84") != OGRERR_NONE)
    return nullptr;
  return std::make_shared<TeGdalProjection>(wgs84);
}

bool TeGdalProjection::prepare() const {
  if (!m_prepared) {
    m_prepared = true;
    OGRSpatialReference wgs84;
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (wgs84.SetWellKnownGeogCS("WGS84") == OGRERR_NONE) {
      m_toWgs84.reset(OGRCreateCoordinateTransformation(&m_system, &wgs84));
      m_fromWgs84.reset(OGRCreateCoordinateTransformation(&wgs84, &m_system));
    }
  }
  return m_toWgs84 && m_fromWgs84;
}

bool TeGdalProjection::toGeographic(double x, double y, TeGeographicPosition& position) const {
  const TeGdalErrors errors;
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (!prepare() || !m_toWgs84->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
    return false;
  position = {x, y};
  return true;
}

bool TeGdalProjection::fromGeographic(TeGeographicPosition position, double& x, double& y) const {
  const TeGdalErrors errors;
  const std::lock_guard<std::mutex> lock(m_mutex);
  double east = position.longitude;
  double north = position.latitude;
  if (!prepare() || !m_fromWgs84->Transform(1, &east, &north) || !std::isfinite(east) ||
      !std::isfinite(north))
    return false;
  x = east;
  y = north;
  return true;
}
