#pragma once

#include "generators/TeHeightMap.h"
#include "generators/elevation/TeElevationOptions.h"

#include <functional>
#include <memory>
#include <string>

/// An elevation file as one square of 2^n + 1 samples a side, without missing ones.
struct TeDemMap {
  static constexpr int kMinCells = 16;
  static constexpr int kMaxCells = 8192;

  std::shared_ptr<const TeHeightMap> heights; ///< metres; row 0 in the south
  double spacing = 1;                         ///< metres
  bool resampled = false;                     ///< samples are not the file's posts
  bool cropped = false;                       ///< the file is no square: this is the one around its middle

  int cells() const { return heights->width() - 1; }

  /// Takes the posts where the file is such a square already and `cells` is 0 or theirs, else the heights
  /// between the posts; `cells` = 0 then means the power of two at or above the file's own, up to kMaxCells.
  /// `progress` is called with 0 .. 1. Error: the file cannot be read; missing heights (how many, and what
  /// helps).
  static TeResult<TeDemMap> read(const std::string& file, const TeElevationOptions& options, int cells,
                                 const std::function<void(double)>& progress);
};
