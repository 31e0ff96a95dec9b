#pragma once

#include <cstdint>
#include <vector>

/// A square window of a level: samples x .. x + side - 1 and y .. y + side - 1; empty if side is 0.
struct TeClipWindow {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t side = 0;

  bool holds(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) const {
    return x0 >= x && y0 >= y && x1 < x + side && y1 < y + side;
  }
};

/// Which samples of a height pyramid can be drawn now. Level i has 2^i + 1 samples a side, row 0 in the
/// south; sample (x, y) of level i is sample (2x, 2y) of level i + 1.
struct TeClipResidency {
  int base = 0; ///< level that is whole; heights of lower levels are read from it
  /// Of levels base .. base + windows.size() - 1; empty for a level that is not up to date or
  /// could not be read; what is drawn then uses no higher one.
  std::vector<TeClipWindow> windows;

  int top() const { return base + int(windows.size()) - 1; }
  /// Whether level `level` (any from 0) has all samples from (x0, y0) to (x1, y1), in samples of that level.
  bool holds(int level, std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) const;
};
