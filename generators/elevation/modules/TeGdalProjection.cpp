#include "generators/elevation/modules/TeGdalProjection.h"

#include "generators/elevation/modules/TeGdalErrors.h"

#include <cmath>

std::shared_ptr<const TeMapProjection> TeGdalProjection::create(const OGRSpatialReference& system) {
  const TeGdalErrors errors;
  OGRSpatialReference file(system);
  file.StripVertical();
  file.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference wgs84;
  if (wgs84.SetWellKnownGeogCS("WGS84") != OGRERR_NONE)
    return nullptr;
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  Transformation to(OGRCreateCoordinateTransformation(&file, &wgs84));
  Transformation from(OGRCreateCoordinateTransformation(&wgs84, &file));
  if (!to || !from)
    return nullptr;
  return std::shared_ptr<const TeMapProjection>(new TeGdalProjection(std::move(to), std::move(from)));
}

bool TeGdalProjection::toGeographic(double x, double y, TeGeographicPosition& position) const {
  const TeGdalErrors errors;
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (!m_toWgs84->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
    return false;
  position = {x, y};
  return true;
}

bool TeGdalProjection::fromGeographic(TeGeographicPosition position, double& x, double& y) const {
  const TeGdalErrors errors;
  const std::lock_guard<std::mutex> lock(m_mutex);
  double east = position.longitude;
  double north = position.latitude;
  if (!m_fromWgs84->Transform(1, &east, &north) || !std::isfinite(east) || !std::isfinite(north))
    return false;
  x = east;
  y = north;
  return true;
}
