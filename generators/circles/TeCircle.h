#pragma once

#include <cstddef>
#include <cstdint>

/// One hill of the circles algorithm in a map: a cosine over a circle,
///
///     height · (1 + cos(π·d/R)) / 2 at the distance d < R from the centre, 0 outside.
///
/// With q = (d/R)² the cosine needs no square root and no library function: (1 + cos(π·√q)) / 2 =
/// (1-q)²·g(q), g a polynomial of degree 4 (interpolated at Chebyshev nodes; error of the hill below
/// 2e-7·height). Exactly 0 outside, and continuous with its slope. Single precision in a fixed order, so a
/// sample has the same bits in a run, by itself and on every machine.
struct TeCircle {
  std::int64_t column = 0; ///< of the sample at or west of the centre
  std::int64_t row = 0;    ///< of the sample at or south of it
  float eastward = 0;      ///< of the centre from there, in samples: a multiple of 1/256 in [0, 1)
  float northward = 0;
  double radius = 1; ///< samples, 1 .. 16384
  float height = 0;  ///< metres, negative in a hollow

  /// The hill in a sample within ±2^30 of the centre; offsets from the centre are exact within the radius.
  float at(std::int64_t x, std::int64_t y) const;
  /// Adds the hill to `count` samples of row y, from column x on.
  void addToRun(std::int64_t x, std::int64_t y, int count, float* heights) const;
  /// Adds the hill to the samples (x[i], y[i]).
  void addToPoints(const std::int32_t* x, const std::int32_t* y, std::size_t count, float* heights) const;
};
