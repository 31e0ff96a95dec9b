#pragma once

#include <algorithm>
#include <cstdint>

/// Samples of a level from (x, y) on, `columns` to the east and `rows` to the north.
struct TeSampleRect {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t columns = 0;
  std::int32_t rows = 0;

  bool isEmpty() const { return columns <= 0 || rows <= 0; }
  std::int64_t count() const { return isEmpty() ? 0 : std::int64_t(columns) * rows; }
  bool holds(std::int32_t column, std::int32_t row) const {
    return column >= x && row >= y && column < x + columns && row < y + rows;
  }

  friend bool operator==(const TeSampleRect& a, const TeSampleRect& b) {
    return a.x == b.x && a.y == b.y && a.columns == b.columns && a.rows == b.rows;
  }
  friend bool operator!=(const TeSampleRect& a, const TeSampleRect& b) { return !(a == b); }
};

/// The samples that are in both; empty if there are none.
inline TeSampleRect teIntersection(const TeSampleRect& a, const TeSampleRect& b) {
  TeSampleRect both;
  both.x = std::max(a.x, b.x);
  both.y = std::max(a.y, b.y);
  both.columns = std::max(0, std::min(a.x + a.columns, b.x + b.columns) - both.x);
  both.rows = std::max(0, std::min(a.y + a.rows, b.y + b.rows) - both.y);
  return both;
}
