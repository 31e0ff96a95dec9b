#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string>
#include <vector>

/// How a file's bytes mean heights.
enum class TeElevationEncoding {
  Automatic, ///< one band of heights, in a format told by the file's content
  Terrarium, ///< three bands: height = 256·R + G + B/256 - 32768 metres
  Raw        ///< 16 bit samples without a header, rows from the north
};

/// The unit of a file's coordinates. Automatic: the file's coordinate system; for a file without one degrees
/// if all coordinates are possible degrees and posts lie closer than 0.1, else metres.
enum class TeHorizontalUnit { Automatic, Metres, Feet, UsFeet, Degrees };

/// What is to be known about a file besides what it says itself. The defaults suit most files.
struct TeElevationOptions {
  TeElevationEncoding encoding = TeElevationEncoding::Automatic;
  int rawColumns = 0; ///< Raw only
  int rawRows = 0;
  bool rawBigEndian = false;
  bool rawSigned = true;

  int band = 1;
  std::string variable; ///< netCDF: which one; empty = the only one

  /// Metres per step of a stored height; 0 = the file's own tag, and metres if it has none.
  double verticalUnit = 0;
  TeHorizontalUnit horizontalUnit = TeHorizontalUnit::Automatic;
  /// Metres between posts, instead of the file's georeference; 0 = the file's, and 1 if it has none.
  double posts = 0;
  /// Stored values that mean "no data", besides those that the file declares.
  std::vector<double> noData;

  /// Fill voids from their surroundings up to this many posts away; 0 = leave them missing.
  int fillDistance = 0;

  static constexpr int kMaxFillDistance = 1000;

  /// Error: an option out of range, named.
  TeStatus check() const;
  std::uint64_t hash() const;
};

/// Metres of a unit by name: m, metre(s), meter(s), dm, decimetre(s), cm, centimetre(s), mm, km, ft, foot,
/// feet, us-ft, us-feet, or a positive number of metres. 0 for "auto". Any case. Error: none of these.
TeResult<double> teVerticalUnit(const std::string& name);
