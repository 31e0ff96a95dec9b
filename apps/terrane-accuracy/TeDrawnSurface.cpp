#include "apps/terrane-accuracy/TeDrawnSurface.h"

#include <algorithm>
#include <limits>

namespace {

/// Twice the area of a triangle, positive if counter-clockwise.
std::int64_t area(const TeSeamlessMesh::Vertex& a, const TeSeamlessMesh::Vertex& b, std::int32_t column,
                  std::int32_t row) {
  return std::int64_t(b.column - a.column) * (row - a.row) -
         std::int64_t(b.row - a.row) * (column - a.column);
}

} // namespace

TeDrawnSurface::TeDrawnSurface(int cells)
    : m_side(cells + 1), m_heights(std::size_t(m_side) * std::size_t(m_side)) {}

void TeDrawnSurface::draw(const std::vector<TeSeamlessMesh::Triangle>& triangles) {
  std::fill(m_heights.begin(), m_heights.end(), std::numeric_limits<float>::quiet_NaN());
  for (const TeSeamlessMesh::Triangle& triangle : triangles) {
    const auto& [a, b, c, strip] = triangle;
    const double whole = double(area(a, b, c.column, c.row));
    if (!(whole > 0))
      continue;
    const auto [west, east] = std::minmax({a.column, b.column, c.column});
    const auto [south, north] = std::minmax({a.row, b.row, c.row});
    for (std::int32_t row = south; row <= north; row++)
      for (std::int32_t column = west; column <= east; column++) {
        const std::int64_t atA = area(b, c, column, row);
        const std::int64_t atB = area(c, a, column, row);
        const std::int64_t atC = area(a, b, column, row);
        if (atA < 0 || atB < 0 || atC < 0)
          continue;
        m_heights[std::size_t(row) * std::size_t(m_side) + std::size_t(column)] =
            float((double(atA) * double(a.height) + double(atB) * double(b.height) +
                   double(atC) * double(c.height)) /
                  whole);
      }
  }
}
