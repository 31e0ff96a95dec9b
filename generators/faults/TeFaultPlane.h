#pragma once

#include <cstdint>

/// The line of a fault in a map, through the points (ax, ay) and (bx, by): 1/256 of a sample from the outer
/// south-west corner of the south-west sample's cell, so that sample (column, row) is at (256·column + 128,
/// 256·row + 128) and points are spread over the cells of all samples. Never along a row: by != ay. The side
/// to the left of the way from a to b rises.
struct TeFaultLine {
  std::int64_t ax = 0;
  std::int64_t ay = 0;
  std::int64_t bx = 0;
  std::int64_t by = 0;
};

/// A fault as an integer function that is linear over the map, value(c, r) = origin + east·c + north·r, with
/// east > 0, and a weight. Its height in a sample is weight times a fixed function of the value:
///
/// step: weight if value > 0, else 0;
/// smooth: weight · (T(value) - 2·T(value - H) + T(value - 2H)) with T(v) = max(v, 0)², H = kRampHalf: two
/// parabolas, from 0 at value 0 to 2·H² from value 2H on, continuous with its slope.
///
/// A line that falls to the east is turned round (weight negative); what it lacks then is the same everywhere
/// in the map: `base` times the full height (1 or 2·H²). All is exact in integers, so that neither the order
/// of summation nor the way (spans or samples) matters. Values stay below 2^48, sums of heights within 2^62.
struct TeFaultPlane {
  static constexpr std::int64_t kRampHalf = std::int64_t(1) << 18; ///< H
  static constexpr std::int64_t kRampFull = 2 * kRampHalf * kRampHalf;

  std::int64_t origin = 0;
  std::int64_t east = 1;
  std::int64_t north = 0;
  std::int64_t weight = 0;
  std::int64_t base = 0;

  /// value > 0 exactly where the cross product (b - a) × (sample - a) is positive.
  static TeFaultPlane step(const TeFaultLine& line, std::int64_t amplitude);
  /// The ramp's middle goes through a and along the line, its width is `width` samples (1 .. 4096); direction
  /// and width are rounded to integer coefficients, by less than 1/100 (at 4096) and 1/10000 (up to 40).
  static TeFaultPlane smooth(const TeFaultLine& line, std::int64_t amplitude, double width);

  std::int64_t value(std::int64_t column, std::int64_t row) const {
    return origin + east * column + north * row;
  }
  std::int64_t stepHeight(std::int64_t value) const { return value > 0 ? weight : 0; }
  std::int64_t smoothHeight(std::int64_t value) const {
    if (value <= 0)
      return 0;
    if (value <= kRampHalf)
      return weight * (value * value);
    if (value < 2 * kRampHalf)
      return weight * (kRampFull - (2 * kRampHalf - value) * (2 * kRampHalf - value));
    return weight * kRampFull;
  }
};
