#pragma once

#include "generators/base/TeResult.h"

#include <array>
#include <memory>
#include <string>

/// A rectangle of posts of a raster: columns from the west, rows from the first stored one.
struct TeRasterWindow {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;
};

/// Longitude and latitude, degrees, WGS 84.
struct TeGeographicPosition {
  double longitude = 0;
  double latitude = 0;
};

/// A file's coordinate system against longitude and latitude. Thread-safe.
class TeMapProjection {
public:
  virtual ~TeMapProjection() = default;
  /// Coordinates of the file, in its unit. False where the projection has no value.
  virtual bool toGeographic(double x, double y, TeGeographicPosition& position) const = 0;
  virtual bool fromGeographic(TeGeographicPosition position, double& x, double& y) const = 0;
};

enum class TeHorizontalKind {
  Unknown,    ///< coordinates of an unknown unit, or none
  Geographic, ///< longitude and latitude
  Linear      ///< a unit of length
};

/// What a raster file says of itself, as it says it; nothing of it is trusted but the sizes, which are
/// positive.
struct TeRasterInfo {
  std::string format; ///< of the driver, for messages
  int columns = 0;
  int rows = 0;
  int bands = 0;

  /// Coordinates of the pixel corner (c, r): x = t[0] + c·t[1] + r·t[2], y = t[3] + c·t[4] + r·t[5]; posts
  /// lie at half numbers, whether the file's pixels are points or areas.
  bool hasTransform = false;
  std::array<double, 6> transform{0, 1, 0, 0, 0, -1};
  bool pixelIsPoint = false; ///< the terrain ends at the outermost posts, not half a step beyond

  TeHorizontalKind horizontal = TeHorizontalKind::Unknown;
  double horizontalUnit = 1; ///< metres, or radians
  double semiMajor = 6378137;
  double inverseFlattening = 298.257223563;

  bool signed16 = false;   ///< 16 bit signed samples
  bool unsigned16 = false; ///< samples of 8 or 16 bits without sign
  bool float32 = false;    ///< single precision samples
  bool hasNoData = false;
  double noData = 0;
  double scale = 1; ///< height in the vertical unit = sample · scale + offset
  double offset = 0;
  std::string verticalUnit; ///< the file's tag, may be empty
};

/// An open raster file: samples by windows. Not thread-safe.
class TeRasterFile {
public:
  virtual ~TeRasterFile() = default;

  const TeRasterInfo& info() const { return m_info; }
  /// Samples of a window, row by row, as numbers; band 1 .. bands. The window lies inside the raster.
  /// Error: the file is damaged there, cannot be read, or would need more memory than the reader allows.
  virtual TeStatus read(int band, TeRasterWindow window, double* samples) = 0;
  /// Null if the file's coordinate system is not known.
  virtual std::shared_ptr<const TeMapProjection> projection() const { return nullptr; }

protected:
  TeRasterInfo m_info;
};
