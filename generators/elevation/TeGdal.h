#pragma once

#include "generators/elevation/TeRasterFile.h"

#include <memory>
#include <string>

/// What elevation data needs of GDAL and PROJ. They live in the module TerraneGdal, which is loaded when a
/// file first needs it, so that programs without elevation data load neither. Loading limits GDAL's cache of
/// blocks, which all its users in a process share, to 64 MB, and keeps PROJ off the network. Thread-safe.
class TeGdal {
public:
  virtual ~TeGdal() = default;

  /// Opens a plain file for reading with one of GDAL's drivers and no other. `variable` names a netCDF
  /// variable; empty = the only one. What the file says of samples is taken from `band`, at least 1; from the
  /// first one if there is no such band. Error: not of that format, damaged, or of hostile proportions.
  virtual TeResult<std::unique_ptr<TeRasterFile>> open(const std::string& path, const std::string& driver,
                                                       const std::string& variable, int band) const = 0;

  /// Fills missing samples (NaN) from the nearest ones in four directions up to `distance` samples away,
  /// by inverse distance (GDALFillNodata without smoothing). What is farther stays missing.
  /// `heights`: columns × rows. Cost: proportional to missing samples times distance.
  virtual TeStatus fillVoids(float* heights, int columns, int rows, int distance) const = 0;

  /// Longitude and latitude in degrees of a file without coordinate system: WGS 84.
  virtual std::shared_ptr<const TeMapProjection> geographicDegrees() const = 0;

  /// The loaded module. Error if it is not installed.
  static TeResult<const TeGdal*> module();
};
