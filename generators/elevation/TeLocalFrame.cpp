#include "generators/elevation/TeLocalFrame.h"

#include "generators/base/TeArcTangent.h"
#include "generators/base/TeMath.h"

#include <algorithm>
#include <cmath>

namespace {
constexpr double kPi = 0x1.921fb54442d18p+1;
}

TeLocalFrame TeLocalFrame::linear(double metresPerUnit) {
  TeLocalFrame frame;
  frame.m_unit = metresPerUnit;
  return frame;
}

TeLocalFrame TeLocalFrame::geographic(double centreLatitude, double radiansPerUnit, double semiMajor,
                                      double inverseFlattening, TePlanePoint extentInUnits) {
  TeLocalFrame frame;
  const double extent = std::max(std::fabs(extentInUnits.x), std::fabs(extentInUnits.y)) * radiansPerUnit;
  frame.m_kind = extent <= kTangentDegrees * (kPi / 180) ? Kind::Tangent : Kind::Plate;
  frame.m_unit = radiansPerUnit;
  frame.m_semiMajor = semiMajor;
  frame.m_latitude = centreLatitude;
  frame.m_sin = teSin(centreLatitude);
  frame.m_cos = teCos(centreLatitude);
  const double flattening = inverseFlattening > 0 ? 1 / inverseFlattening : 0;
  frame.m_axisRatio = (1 - flattening) * (1 - flattening);
  const double e2 = 1 - frame.m_axisRatio;
  frame.m_normalRadius = semiMajor / std::sqrt(1 - e2 * frame.m_sin * frame.m_sin);
  return frame;
}

const char* TeLocalFrame::name() const {
  return m_kind == Kind::Linear ? "linear" : m_kind == Kind::Tangent ? "tangent" : "plate";
}

bool TeLocalFrame::toFile(TePlanePoint local, TePlanePoint& offset) const {
  if (!std::isfinite(local.x) || !std::isfinite(local.y))
    return false;
  if (m_kind == Kind::Linear) {
    offset = {local.x / m_unit, local.y / m_unit};
    return true;
  }
  if (m_kind == Kind::Plate) {
    offset = {local.x / (m_semiMajor * m_cos) / m_unit, local.y / m_semiMajor / m_unit};
    return true;
  }
  return tangentToFile(local, offset);
}

bool TeLocalFrame::toLocal(TePlanePoint offset, TePlanePoint& local) const {
  if (!std::isfinite(offset.x) || !std::isfinite(offset.y))
    return false;
  if (m_kind == Kind::Linear) {
    local = {offset.x * m_unit, offset.y * m_unit};
    return true;
  }
  if (m_kind == Kind::Plate) {
    local = {offset.x * m_unit * m_semiMajor * m_cos, offset.y * m_unit * m_semiMajor};
    return true;
  }
  return tangentToLocal(offset, local);
}

// The plane's point is moved along the normal by u metres until it lies on the ellipsoid X²+Y²+Z²/q = a²,
// which is F·u² + 2·B·u + C = 0; the root is taken in the form that does not cancel. X and Y are in the
// equator's plane with X in the centre's meridian.
bool TeLocalFrame::tangentToFile(TePlanePoint local, TePlanePoint& offset) const {
  const double q = m_axisRatio;
  const double x = local.x;
  const double y = local.y;
  const double f = m_cos * m_cos + m_sin * m_sin / q;
  const double b = m_normalRadius + y * (m_sin * m_cos * (1 / q - 1));
  const double c = x * x + y * y * (m_sin * m_sin + m_cos * m_cos / q);
  const double discriminant = b * b - f * c;
  if (!(discriminant >= 0) || !(b > 0))
    return false;
  const double u = -c / (b + std::sqrt(discriminant));
  const double earthX = m_normalRadius * m_cos - y * m_sin + u * m_cos;
  const double earthZ = m_normalRadius * q * m_sin + y * m_cos + u * m_sin;
  const double longitude = teAtan2(x, earthX);
  const double latitude = teAtan2(earthZ, q * std::sqrt(earthX * earthX + x * x));
  offset = {longitude / m_unit, (latitude - m_latitude) / m_unit};
  return true;
}

bool TeLocalFrame::tangentToLocal(TePlanePoint offset, TePlanePoint& local) const {
  const double longitude = offset.x * m_unit;
  const double latitude = m_latitude + offset.y * m_unit;
  const double sinLatitude = teSin(latitude);
  const double cosLatitude = teCos(latitude);
  const double radius =
      m_semiMajor / std::sqrt(1 - (1 - m_axisRatio) * sinLatitude * sinLatitude); // N of this point
  const double east = radius * cosLatitude * teSin(longitude);
  const double earthX = radius * cosLatitude * teCos(longitude) - m_normalRadius * m_cos;
  const double earthZ = m_axisRatio * (radius * sinLatitude - m_normalRadius * m_sin);
  local = {east, earthZ * m_cos - earthX * m_sin};
  // Visible from above the centre: the normal's component of the point's own normal is positive.
  return sinLatitude * m_sin + cosLatitude * m_cos * teCos(longitude) > 0;
}
