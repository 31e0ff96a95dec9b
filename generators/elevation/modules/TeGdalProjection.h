#pragma once

#include "generators/elevation/TeRasterFile.h"

#include <ogr_spatialref.h>

#include <memory>
#include <mutex>

/// A coordinate system of a file, by PROJ.
class TeGdalProjection final : public TeMapProjection {
public:
  /// Null if PROJ knows no way to longitude and latitude. Longitudes are taken as the file counts them
  /// (0 .. 360 too).
  static std::shared_ptr<const TeMapProjection> create(const OGRSpatialReference& system);

  bool toGeographic(double x, double y, TeGeographicPosition& position) const override;
  bool fromGeographic(TeGeographicPosition position, double& x, double& y) const override;

private:
  using Transformation = std::unique_ptr<OGRCoordinateTransformation>;
  TeGdalProjection(Transformation toWgs84, Transformation fromWgs84)
      : m_toWgs84(std::move(toWgs84)), m_fromWgs84(std::move(fromWgs84)) {}

  mutable std::mutex m_mutex; ///< transformations are not thread-safe
  Transformation m_toWgs84;
  Transformation m_fromWgs84;
};
