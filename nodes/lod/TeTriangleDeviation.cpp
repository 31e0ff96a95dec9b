#include "nodes/lod/TeTriangleDeviation.h"

#include "nodes/lod/TeLatticeTriangle.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

TE_TARGET_CLONES
double rowDeviation(const float* heights, int count, double start, double slope) {
  double worst = 0;
  for (int i = 0; i < count; i++) {
    const double deviation = std::fabs(double(heights[i]) - (start + slope * i));
    worst = deviation > worst ? deviation : worst;
  }
  return worst;
}

} // namespace

float teTriangleDeviation(const TeHeightMap& heights, const TeLodVertex& a, const TeLodVertex& b,
                          const TeLodVertex& c) {
  const std::int64_t bx = b.column - a.column, by = b.row - a.row;
  const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
  const double area = double(bx * cy - cx * by);
  const double bz = double(b.height) - double(a.height), cz = double(c.height) - double(a.height);
  const double alongX = (bz * double(cy) - cz * double(by)) / area;
  const double alongY = (cz * double(bx) - bz * double(cx)) / area;

  double worst = 0;
  const TeLatticeTriangle triangle(a, b, c);
  for (std::int32_t row = triangle.firstRow(); row <= triangle.lastRow(); row++) {
    const TeLatticeTriangle::Span span = triangle.span(row);
    const double start =
        double(a.height) + alongX * double(span.first - a.column) + alongY * double(row - a.row);
    worst = std::max(worst,
                     rowDeviation(heights.row(row) + span.first, span.last - span.first + 1, start, alongX));
  }
  const float rounded = float(worst);
  return double(rounded) < worst ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}
