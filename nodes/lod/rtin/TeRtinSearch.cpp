#include "nodes/lod/rtin/TeRtinSearch.h"

#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

/// Rows of a triangle with one leg along x and one along y.
struct Rows {
  const float* samples; ///< the first of the first row
  std::ptrdiff_t step;  ///< from the first of a row to that of the next
  int count;            ///< samples of the first row
  int countStep;        ///< 1 or -1
  int rows;
  double start; ///< of the plane at the first sample
  double startStep;
  double slope; ///< along rows
};

/// Numbers that are not negative order as their bits do, whose maximum is vectorised.
TE_TARGET_CLONES
double rowsDeviation(const Rows& rows) {
  std::int64_t worst = 0;
  const float* samples = rows.samples;
  for (int row = 0; row < rows.rows; row++) {
    const double start = rows.start + rows.startStep * row, slope = rows.slope;
    const int count = rows.count + rows.countStep * row;
    for (int i = 0; i < count; i++) {
      const double deviation = std::fabs(double(samples[i]) - (start + slope * i));
      std::int64_t bits;
      std::memcpy(&bits, &deviation, sizeof bits);
      worst = bits > worst ? bits : worst;
    }
    samples += rows.step;
  }
  double result;
  std::memcpy(&result, &worst, sizeof result);
  return result;
}

} // namespace

double TeRtinSearch::deviation(int x, int y) const {
  return std::fabs(double(m_heights.at(x, y)) - (m_plane.origin + m_plane.alongX * x + m_plane.alongY * y));
}

void TeRtinSearch::look(const Point& a, const Point& b, const Point& apex) {
  const int lowY = std::min(a.y, b.y), highY = std::max(a.y, b.y), lowX = std::min(a.x, b.x),
            highX = std::max(a.x, b.x);
  const bool widensUpward = apex.y == highY, apexIsWest = apex.x == lowX;
  Rows rows{};
  rows.rows = highY - lowY + 1;
  rows.count = widensUpward ? 1 : highX - lowX + 1;
  rows.countStep = widensUpward ? 1 : -1;
  // Rows begin at the leg along y, or at the hypotenuse.
  const int firstX = apexIsWest ? lowX : widensUpward ? highX : lowX;
  const int shift = apexIsWest ? 0 : widensUpward ? -1 : 1;
  rows.samples = m_heights.row(lowY) + firstX;
  rows.step = std::ptrdiff_t(m_heights.width()) + shift;
  rows.start = m_plane.origin + m_plane.alongX * firstX + m_plane.alongY * lowY;
  rows.startStep = m_plane.alongY + m_plane.alongX * shift;
  rows.slope = m_plane.alongX;
  m_worst = std::max(m_worst, rowsDeviation(rows));
}

void TeRtinSearch::search(const Point& a, const Point& b, const Point& apex) {
  if (std::abs(apex.x - a.x) + std::abs(apex.y - a.y) == m_least && (apex.x == a.x || apex.y == a.y)) {
    look(a, b, apex);
    return;
  }
  Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2, 0};
  middle.deviation = deviation(middle.x, middle.y);
  m_worst = std::max(m_worst, middle.deviation);
  const auto bound = [&](const Point& end) {
    const int x = (end.x + apex.x) / 2, y = (end.y + apex.y) / 2;
    return double(m_errors[std::ptrdiff_t(y) * m_heights.width() + x]) +
           std::max({end.deviation, apex.deviation, middle.deviation});
  };
  const double boundOfA = bound(a), boundOfB = bound(b);
  const bool aFirst = boundOfA > boundOfB;
  if ((aFirst ? boundOfA : boundOfB) > m_worst)
    aFirst ? search(apex, a, middle) : search(b, apex, middle);
  if ((aFirst ? boundOfB : boundOfA) > m_worst)
    aFirst ? search(b, apex, middle) : search(apex, a, middle);
}

void TeRtinSearch::raise(int x, int y, const Point& a, const Point& b, const Point& apex) {
  float& error = m_errors[std::ptrdiff_t(y) * m_heights.width() + x];
  const double ha = double(m_heights.at(a.x, a.y)), hb = double(m_heights.at(b.x, b.y)),
               hc = double(m_heights.at(apex.x, apex.y));
  const int ax = a.x - apex.x, ay = a.y - apex.y, bx = b.x - apex.x, by = b.y - apex.y;
  const double area = double(std::int64_t(ax) * by - std::int64_t(bx) * ay);
  m_plane.alongX = ((ha - hc) * by - (hb - hc) * ay) / area;
  m_plane.alongY = ((hb - hc) * ax - (ha - hc) * bx) / area;
  m_plane.origin = hc - m_plane.alongX * apex.x - m_plane.alongY * apex.y;
  m_worst = double(error);
  search(a, b, apex);
  const float rounded = float(m_worst);
  error =
      double(rounded) < m_worst ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

void TeRtinSearch::raiseSides(int size) {
  const int cells = m_heights.width() - 1, half = size / 2;
  for (int y = 0; y < cells; y += size)
    for (int x = 0; x < cells; x += size) {
      const Point southWest{x, y, 0}, southEast{x + size, y, 0}, northWest{x, y + size, 0},
          northEast{x + size, y + size, 0}, centre{x + half, y + half, 0};
      raise(x + half, y, southWest, southEast, centre);
      raise(x + size, y + half, southEast, northEast, centre);
      raise(x + half, y + size, northEast, northWest, centre);
      raise(x, y + half, northWest, southWest, centre);
    }
}

void TeRtinSearch::raiseDiagonals(int size) {
  const int cells = m_heights.width() - 1, half = size / 2;
  for (int y = 0; y < cells; y += size)
    for (int x = 0; x < cells; x += size) {
      const bool risesEast = (x / size + y / size) % 2 == 0;
      const Point a{risesEast ? x : x + size, y, 0}, b{risesEast ? x + size : x, y + size, 0};
      raise(x + half, y + half, a, b, {b.x, a.y, 0});
      raise(x + half, y + half, a, b, {a.x, b.y, 0});
    }
}
