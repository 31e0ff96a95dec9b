#include "apps/terrane-accuracy/TeDrawnSurface.h"

#include "nodes/lod/TeLatticeTriangle.h"

#include <algorithm>
#include <limits>

TeDrawnSurface::TeDrawnSurface(int cells)
    : m_side(cells + 1), m_heights(std::size_t(m_side) * std::size_t(m_side)) {}

void TeDrawnSurface::draw(const TeLodMesh& mesh) {
  std::fill(m_heights.begin(), m_heights.end(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const TeLodVertex& a = mesh.vertices[mesh.indices[i]];
    const TeLodVertex& b = mesh.vertices[mesh.indices[i + 1]];
    const TeLodVertex& c = mesh.vertices[mesh.indices[i + 2]];
    const std::int64_t bx = b.column - a.column, by = b.row - a.row;
    const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
    const double area = double(bx * cy - cx * by);
    if (area == 0)
      continue;
    const double bz = double(b.height) - double(a.height), cz = double(c.height) - double(a.height);
    const double alongX = (bz * double(cy) - cz * double(by)) / area;
    const double alongY = (cz * double(bx) - bz * double(cx)) / area;
    const TeLatticeTriangle triangle(a, b, c);
    for (std::int32_t row = triangle.firstRow(); row <= triangle.lastRow(); row++) {
      const TeLatticeTriangle::Span span = triangle.span(row);
      const double start = double(a.height) + alongY * double(row - a.row) - alongX * double(a.column);
      float* heights = &m_heights[std::size_t(row) * std::size_t(m_side)];
      for (std::int32_t column = span.first; column <= span.last; column++)
        heights[column] = float(start + alongX * column);
    }
  }
}
