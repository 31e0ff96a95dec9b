#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeFlyover.h"

#include <string>

/// A square terrain to measure on: 2^n + 1 samples a side, none missing.
struct TeMeasuredTerrain {
  static constexpr int kMaxSamples = 8193; ///< a side

  std::string name;       ///< of the file
  TeHeightMap heights;    ///< in the unit of its samples, row 0 in the south
  double spacing = 1;     ///< metres
  double heightScale = 1; ///< metres a unit

  int cells() const { return heights.width() - 1; }
  /// The peers' flight over this terrain, which must outlive it.
  TeFlyover flyover() const;

  /// Headerless little-endian samples of 16 bits, the first row in the south. Error: a file that cannot be
  /// read, or whose size is not that of a square of 2^n + 1 samples.
  static TeResult<TeMeasuredTerrain> readMap(const std::string& file, double spacing, double heightScale);
  /// The largest square of 2^n + 1 posts in the middle of an elevation file, at its own posts. Error: a file
  /// that cannot be read, whose posts are not equally far apart, or with missing heights there.
  static TeResult<TeMeasuredTerrain> readDem(const std::string& file);
};
