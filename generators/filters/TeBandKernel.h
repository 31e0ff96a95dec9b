#pragma once

#include <cstddef>

/// The two inner loops of the band filter over a padded grid, for one kind of processor. All kinds give the
/// same bits: h = previous * rest + h * k in float, rounded after each operation.
struct TeBandKernel {
  /// Widths and strides are multiples of this many floats.
  static constexpr int kPadding = 16;
  /// Rows and columns of what is transposed are multiples of this many.
  static constexpr int kTile = 8;

  const char* name;
  /// Floats that one vector register holds.
  int lanes;

  /// Filters `count` ≥ 1 rows of `width` columns each in place, from `row` on in steps of `step` floats
  /// (negative to go backwards). `before` is the row that precedes the first, already filtered; null: the
  /// first row stays as it is. No height may be missing or beyond 1e38 in size.
  void (*sweep)(float* row, std::ptrdiff_t step, int count, int width, const float* before, float k);
  /// The same for any heights: a missing one stays missing, and the recursion starts anew behind it; a result
  /// beyond float's range is missing.
  void (*sweepCareful)(float* row, std::ptrdiff_t step, int count, int width, const float* before, float k);
  /// out[x][y] = in[y][x]; both sides multiples of kTile.
  void (*transpose)(const float* in, std::ptrdiff_t inStride, int rows, int columns, float* out,
                    std::ptrdiff_t outStride);

  /// The fastest one for this processor. The environment does not change it.
  static const TeBandKernel& best();

  static const TeBandKernel baseline;
  static const TeBandKernel avx2;
  static const TeBandKernel avx512;
};
