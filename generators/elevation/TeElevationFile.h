#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TeElevationTiles.h"
#include "generators/elevation/TeLocalFrame.h"
#include "generators/elevation/TeRasterFormat.h"

#include <cstdint>
#include <memory>
#include <string>

/// A rectangle of the local plane, metres east and north of the file's centre.
struct TeLocalExtent {
  double west = 0;
  double south = 0;
  double east = 0;
  double north = 0;

  double width() const { return east - west; }
  double height() const { return north - south; }
};

/// An elevation file: a grid of *posts* (stored heights) in a plane of local metres around the file's centre
/// (TeLocalFrame). Post (c, r), column c from the first column, row r from the first stored row, lies at the
/// post coordinates (c, r); the terrain reaches from the first to the last post, and half a step beyond where
/// the file's pixels are areas.
///
/// Immutable and thread-safe; reads what is asked for in tiles (TeElevationTiles), so that memory does not
/// depend on the file's size. Errors name the file.
class TeElevationFile {
public:
  /// A plain file of one of the formats of teRasterFormat(), or headerless. Error: missing, damaged, of
  /// another kind, with a georeference that means nothing, or of hostile proportions.
  static TeResult<std::shared_ptr<const TeElevationFile>> open(const std::string& path,
                                                               const TeElevationOptions& options = {});

  const std::string& path() const { return m_path; }
  const std::string& format() const { return m_tiles->info().format; }
  int columns() const { return m_tiles->info().columns; }
  int rows() const { return m_tiles->info().rows; }
  const TeLocalFrame& frame() const { return m_frame; }
  const TeElevationTiles& tiles() const { return *m_tiles; }
  /// Metres of one stored step of height.
  double verticalUnit() const { return m_verticalUnit; }
  /// Bounds of the terrain in the local plane. In the tangent plane the terrain has curved sides inside them.
  const TeLocalExtent& extent() const { return m_extent; }
  /// Metres between neighbouring posts at the centre: along a row, along a column.
  TePlanePoint postSpacing() const { return m_postSpacing; }
  /// The one spacing of all posts. Error if it differs between directions or places (degrees, rotation).
  TeResult<double> nativeSpacing() const;
  /// True if columns run east (rows north); only where nativeSpacing() exists.
  bool columnsRunEast() const { return m_transform[1] > 0; }
  bool rowsRunNorth() const { return m_transform[5] > 0; }
  /// Hash of the options and of the file's state: size, time of change and some of its bytes.
  std::uint64_t fingerprint() const { return m_fingerprint; }

  /// Height of a post, metres or missing. The post exists.
  TeResult<float> post(int column, int row) const;

  /// Local position to post coordinates, and back; also outside the terrain. Coordinates within a millionth
  /// of a step of a whole number become it. False where the plane has no point of the Earth.
  bool toPosts(TePlanePoint local, TePlanePoint& posts) const;
  bool toLocal(TePlanePoint posts, TePlanePoint& local) const;
  /// True if there is terrain at these post coordinates.
  bool contains(TePlanePoint posts) const;

  /// Local position to longitude and latitude (WGS 84), and back. Error: the file has no known coordinate
  /// system, or the position has no counterpart.
  TeResult<TeGeographicPosition> toGeographic(TePlanePoint local) const;
  TeResult<TePlanePoint> fromGeographic(TeGeographicPosition position) const;

  /// The smallest spacing at which a block of patches × patches patches of source maps of `samples` samples,
  /// centred on the file's centre, covers the whole extent; that of the posts if there is but one. Error:
  /// sizes out of range.
  TeResult<double> coveringSpacing(int patches, int samples) const;

private:
  TeElevationFile() = default;
  TeStatus openRaster(const TeElevationOptions& options);
  void chooseVerticalUnit(const TeElevationOptions& options, const TeRasterInfo& info);
  TeStatus chooseFrame(const TeElevationOptions& options, TeRasterInfo info);
  TeStatus measure();
  TeStatus computeFingerprint(const TeElevationOptions& options);

  std::string m_path;
  std::unique_ptr<TeElevationTiles> m_tiles;
  std::shared_ptr<const TeMapProjection> m_projection;
  TeLocalFrame m_frame;
  std::array<double, 6> m_transform{};
  double m_determinant = 1;
  TePlanePoint m_centre; ///< in the file's coordinates
  double m_fullTurn = 0; ///< 360 degrees in the file's unit; 0 if linear
  double m_margin = 0;   ///< steps of terrain beyond the outermost posts
  double m_verticalUnit = 1;
  TePlanePoint m_postSpacing;
  TeLocalExtent m_extent;
  std::uint64_t m_fingerprint = 0;
};

using TeElevationFilePtr = std::shared_ptr<const TeElevationFile>;
