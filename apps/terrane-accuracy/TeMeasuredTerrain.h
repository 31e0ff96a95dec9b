#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/TeLodField.h"

#include <string>

/// A square terrain to measure on: 2^n + 1 samples a side, none missing.
struct TeMeasuredTerrain {
  static constexpr int kMaxSamples = 8193; ///< a side

  std::string name;    ///< of the file
  TeLodFieldPtr field; ///< with its corner at 0

  const TeHeightMap& heights() const { return field->heights(); }
  int cells() const { return field->cells(); }
  double spacing() const { return field->spacing(); }
  double heightScale() const { return field->heightScale(); }
  /// Of the heights: so many samples a side, or all if there are fewer.
  TeMapRect middle(int samples) const;
  /// The peers' flight over this terrain.
  TeFlyover flyover() const;

  /// Errors of TeLodField::create().
  static TeResult<TeMeasuredTerrain> create(const std::string& name, TeHeightMap heights, double spacing,
                                            double heightScale);

  /// Headerless little-endian samples of 16 bits, the first row in the south. Error: a file that cannot be
  /// read, or whose size is not that of a square of 2^n + 1 samples.
  static TeResult<TeMeasuredTerrain> readMap(const std::string& file, double spacing, double heightScale);
  /// The largest square of 2^n + 1 posts in the middle of an elevation file, at its own posts. Error: a file
  /// that cannot be read, whose posts are not equally far apart, or with missing heights there.
  static TeResult<TeMeasuredTerrain> readDem(const std::string& file, const TeElevationOptions& options = {});
};
