#include "nodes/lod/TeTriangleDeviation.h"

#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace {

/// Where an edge crosses row after row: column = whole + rest / rows, exactly, 0 <= rest < rows.
struct EdgeWalk {
  std::int32_t rows = 1;
  std::int32_t wholeStep = 0;
  std::int32_t restStep = 0;
  std::int32_t whole = 0;
  std::int32_t rest = 0;

  /// From the row of `low`; upward, or along a row.
  EdgeWalk(const TeLodVertex& low, const TeLodVertex& high) : whole(low.column) {
    const std::int32_t columns = high.column - low.column;
    rows = std::max(1, high.row - low.row);
    wholeStep = columns / rows;
    restStep = columns % rows;
    if (restStep < 0) {
      restStep += rows;
      wholeStep--;
    }
  }
  std::int32_t floor() const { return whole; }
  std::int32_t ceil() const { return whole + (rest > 0); }
  void step() {
    whole += wholeStep;
    rest += restStep;
    if (rest >= rows) {
      rest -= rows;
      whole++;
    }
  }
};

/// Height = start + alongX·column along a row, and alongY more from row to row.
struct Plane {
  double alongX;
  double alongY;
  double origin; ///< at (column, row)
  std::int32_t column;
  std::int32_t row;

  double at(std::int32_t x, std::int32_t y) const {
    return origin + alongX * double(x - column) + alongY * double(y - row);
  }
};

/// Samples of a row that are not worth the set-up of vector instructions.
constexpr std::int32_t kNarrow = 12;

/// Not negative numbers order as their bits do; compilers vectorise the maximum of integers, but not that of
/// doubles, whose NaN they must keep.
std::int64_t bitsOf(double notNegative) {
  std::int64_t bits;
  std::memcpy(&bits, &notNegative, sizeof bits);
  return bits;
}

struct Rows {
  const float* samples;
  std::int64_t width;
  std::int32_t from;
  std::int32_t to; ///< behind the last one
};

/// The largest deviation in rows between two edges.
double narrowDeviation(const Rows& rows, const Plane& plane, EdgeWalk& left, EdgeWalk& right) {
  double worst = 0;
  for (std::int32_t row = rows.from; row < rows.to; row++) {
    const std::int32_t first = left.ceil(), last = right.floor();
    const float* heights = rows.samples + row * rows.width;
    const double start = plane.at(first, row);
    for (std::int32_t column = first; column <= last; column++) {
      const double deviation = std::fabs(double(heights[column]) - (start + plane.alongX * (column - first)));
      worst = deviation > worst ? deviation : worst;
    }
    left.step();
    right.step();
  }
  return worst;
}

TE_TARGET_CLONES
double wideDeviation(const Rows& rows, const Plane& plane, EdgeWalk& left, EdgeWalk& right) {
  std::int64_t worst = 0;
  for (std::int32_t row = rows.from; row < rows.to; row++) {
    const std::int32_t first = left.ceil(), count = right.floor() - first + 1;
    const float* heights = rows.samples + row * rows.width + first;
    const double start = plane.at(first, row), slope = plane.alongX;
    for (std::int32_t i = 0; i < count; i++) {
      const std::int64_t deviation = bitsOf(std::fabs(double(heights[i]) - (start + slope * i)));
      worst = deviation > worst ? deviation : worst;
    }
    left.step();
    right.step();
  }
  double result;
  std::memcpy(&result, &worst, sizeof result);
  return result;
}

} // namespace

float teTriangleDeviation(const TeHeightMap& heights, const TeLodVertex& a, const TeLodVertex& b,
                          const TeLodVertex& c) {
  const std::int64_t bx = b.column - a.column, by = b.row - a.row;
  const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
  const double area = double(bx * cy - cx * by);
  const double bz = double(b.height) - double(a.height), cz = double(c.height) - double(a.height);
  const Plane plane{(bz * double(cy) - cz * double(by)) / area, (cz * double(bx) - bz * double(cx)) / area,
                    double(a.height), a.column, a.row};

  const TeLodVertex* low = &a;
  const TeLodVertex* middle = &b;
  const TeLodVertex* high = &c;
  if (low->row > middle->row)
    std::swap(low, middle);
  if (middle->row > high->row)
    std::swap(middle, high);
  if (low->row > middle->row)
    std::swap(low, middle);
  // The edge from low to high, and on its other side that over the third corner.
  const std::int64_t side = (std::int64_t(middle->column) - low->column) * (high->row - low->row) -
                            (std::int64_t(high->column) - low->column) * (middle->row - low->row);
  EdgeWalk whole(*low, *high);
  EdgeWalk broken(*low, *middle);
  const bool isNarrow =
      std::max({a.column, b.column, c.column}) - std::min({a.column, b.column, c.column}) < kNarrow;
  const auto deviation = [&](std::int32_t from, std::int32_t to) {
    const Rows rows{heights.data(), heights.width(), from, to};
    EdgeWalk& left = side > 0 ? whole : broken;
    EdgeWalk& right = side > 0 ? broken : whole;
    return isNarrow ? narrowDeviation(rows, plane, left, right) : wideDeviation(rows, plane, left, right);
  };
  const double lower = deviation(low->row, middle->row);
  broken = EdgeWalk(*middle, *high);
  const double worst = std::max(lower, deviation(middle->row, high->row + 1));

  const float rounded = float(worst);
  return double(rounded) < worst ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}
