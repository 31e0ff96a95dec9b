#pragma once

#include "generators/base/TeResult.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// A picture of width × height pixels, 8 bits each of red, green, blue and alpha.
///
/// Pixel (column x, row y) is pixel(x, y) = rgba[4·(y·width + x) ..]; row 0 is the lowest.
struct TePicture {
  using Pixel = std::array<std::uint8_t, 4>;
  static constexpr int kMaxSide = 16384;

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  Pixel pixel(int x, int y) const {
    const std::uint8_t* p = &rgba[4 * (std::size_t(y) * width + x)];
    return {p[0], p[1], p[2], p[3]};
  }

  /// Error: no pixels, or not as many as the sides say; a side above kMaxSide; the file cannot be written.
  /// The message names it and says why.
  TeStatus writePng(const std::string& path) const;
  /// Reads a PNG of any colour type. Error: no such file, not a PNG, damaged, a side above kMaxSide.
  static TeResult<TePicture> readPng(const std::string& path);

  friend bool operator==(const TePicture& a, const TePicture& b) {
    return a.width == b.width && a.height == b.height && a.rgba == b.rgba;
  }
  friend bool operator!=(const TePicture& a, const TePicture& b) { return !(a == b); }
};
