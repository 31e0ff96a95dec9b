#pragma once

#include "generators/TeHeightMap.h"

#include <string>

/// A square elevation file, read whole: what a height map for drawing is made from.
struct TeSeamlessHeightFile {
  TeHeightMap map; ///< 2^n + 1 samples a side, row 0 in the south; metres, or numbers if `isRaw`
  bool isRaw = false;
  /// Metres between samples; 0 if the file does not say, or not one for all (degrees).
  double spacing = 0;

  /// `path`: *.raw is a headerless square of unsigned 16 bit numbers, little-endian, rows from the north;
  /// anything else one of the formats of TeElevationFile. `verticalUnit`: metres of a stored step; 0: as the
  /// file says, and numbers as they are in *.raw. Error: the file cannot be read, is no square of 2^n + 1
  /// samples, is rotated, or has missing samples; the message says which, and the file.
  static TeResult<TeSeamlessHeightFile> read(const std::string& path, double verticalUnit);
};
