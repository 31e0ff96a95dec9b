#pragma once

#include <cmath>
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

  /// Distances of a column and a row from the centre, in samples; exact within the radius.
  float fromCentreX(std::int64_t x) const { return float(x - column) - eastward; }
  float fromCentreY(std::int64_t y) const { return float(y - row) - northward; }
  float inverseSquareRadius() const { return float(1.0 / (radius * radius)); }

  /// The hill at dx, dy; `scale` is inverseSquareRadius().
  static float hill(float dx, float dy, float scale, float height) {
    const float q = (dx * dx + dy * dy) * scale;
    const float rest = 1.0f - q;
    const float t = 0.5f * (rest + std::fabs(rest)); // the positive part, exact, without a branch
    const float g =
        1.0f + q * (-0.467396855f + q * (0.0945197507f + q * (-0.0110260951f + q * 0.000753640876f)));
    return (t * t) * (g * height);
  }
};
