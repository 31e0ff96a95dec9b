#pragma once

#include "generators/elevation/TeRasterFile.h"

#include <ogr_spatialref.h>

#include <memory>
#include <mutex>

/// A coordinate system of a file, by PROJ. The search for the way to longitude and latitude, some 10 ms, is
/// put off until someone asks.
class TeGdalProjection final : public TeMapProjection {
public:
  /// Longitudes are taken as the file counts them (0 .. 360 too).
  explicit TeGdalProjection(const OGRSpatialReference& system);
  /// Longitude and latitude in degrees, WGS 84.
  static std::shared_ptr<const TeMapProjection> degrees();

  bool toGeographic(double x, double y, TeGeographicPosition& position) const override;
  bool fromGeographic(TeGeographicPosition position, double& x, double& y) const override;

private:
  /// Finds the transformations on first use; false if PROJ knows none.
  bool prepare() const;

  mutable std::mutex m_mutex; ///< transformations are not thread-safe
  OGRSpatialReference m_system;
  mutable bool m_prepared = false;
  mutable std::unique_ptr<OGRCoordinateTransformation> m_toWgs84;
  mutable std::unique_ptr<OGRCoordinateTransformation> m_fromWgs84;
};
