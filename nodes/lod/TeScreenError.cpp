#include "nodes/lod/TeScreenError.h"

#include "patchdb/TeTargetClones.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using Vertex = TeScreenError::Vertex;

/// What a row of samples is seen with: of every plane the distance at column 0, and per column and height.
struct RowView {
  double planeStart[6];
  double planeColumn[6];
  double planeHeight[6];
  int planeCount;
  double x0, dx, y2, z0, heightScale; ///< relative to the eye; y2 is squared
  double pixels;                      ///< of a unit of height at a distance of 1
  bool perspective;
};

/// Squares of the deviations in pixels; negative for what is not seen.
TE_TARGET_CLONES
void squaresOfRow(const RowView& view, const float* heights, const float* deviations, int count,
                  double* squares) {
  for (int i = 0; i < count; i++)
    squares[i] = 0;
  for (int plane = 0; plane < view.planeCount; plane++) {
    const double start = view.planeStart[plane], column = view.planeColumn[plane],
                 height = view.planeHeight[plane];
    for (int i = 0; i < count; i++) {
      const double inside = start + column * i + height * double(heights[i]);
      squares[i] = inside >= 0 ? squares[i] : -1;
    }
  }
  for (int i = 0; i < count; i++) {
    const double x = view.x0 + view.dx * i;
    const double z = view.z0 + view.heightScale * double(heights[i]);
    const double distance2 = view.perspective ? x * x + view.y2 + z * z : 1;
    const double pixels = double(deviations[i]) * view.pixels;
    const double square = pixels * pixels;
    const double scaled = square / distance2;
    squares[i] = squares[i] < 0 ? -1 : (square > 0 ? scaled : 0);
  }
}

} // namespace

TeScreenError::TeScreenError(const TeHeightMap& heights, const glm::dvec3& corner, double spacing,
                             double heightScale)
    : m_heights(&heights), m_corner(corner), m_spacing(spacing), m_heightScale(heightScale) {
  clear();
}

void TeScreenError::clear() {
  const std::size_t count = std::size_t(m_heights->width()) * std::size_t(m_heights->height());
  m_deviations.assign(count, -1.0f);
  m_covered.assign(count, 0);
  m_triangles = 0;
  m_foreign = 0;
}

bool TeScreenError::isForeign(const Vertex& a, const Vertex& b, const Vertex& c) const {
  for (const Vertex* vertex : {&a, &b, &c})
    if (vertex->column < 0 || vertex->row < 0 || vertex->column >= m_heights->width() ||
        vertex->row >= m_heights->height() || !std::isfinite(vertex->height))
      return true;
  return false;
}

void TeScreenError::add(const Vertex& a, const Vertex& b, const Vertex& c) {
  if (isForeign(a, b, c)) {
    m_foreign++;
    return;
  }
  const std::int64_t bx = b.column - a.column, by = b.row - a.row;
  const std::int64_t cx = c.column - a.column, cy = c.row - a.row;
  const std::int64_t area = bx * cy - cx * by;
  if (area == 0) {
    m_foreign++;
    return;
  }
  m_triangles++;
  const double bz = double(b.height) - double(a.height), cz = double(c.height) - double(a.height);
  const double alongX = (bz * double(cy) - cz * double(by)) / double(area);
  const double alongY = (cz * double(bx) - bz * double(cx)) / double(area);

  const TeLatticeTriangle triangle(a, b, c);
  for (std::int32_t row = triangle.firstRow(); row <= triangle.lastRow(); row++) {
    const TeLatticeTriangle::Span span = triangle.span(row);
    addRow(row, span, double(a.height) + alongY * double(row - a.row) - alongX * double(a.column), alongX);
  }
}

void TeScreenError::addRow(int row, const TeLatticeTriangle::Span& span, double start, double slope) {
  const std::size_t offset = std::size_t(row) * std::size_t(m_heights->width());
  const float* heights = m_heights->row(row);
  float* deviations = m_deviations.data() + offset;
  std::uint8_t* covered = m_covered.data() + offset;
  for (int x = span.first; x <= span.last; x++) {
    const float deviation = float(std::fabs(double(heights[x]) - (start + slope * x)));
    deviations[x] = deviation > deviations[x] ? deviation : deviations[x];
  }
  for (int x = span.first; x < span.openEnd; x++)
    covered[x] = std::uint8_t(std::min(covered[x] + 1, 2));
}

TeScreenError::Report TeScreenError::measure(const TeLodView& view) {
  Report report;
  report.triangles = m_triangles;
  report.foreign = m_foreign;
  for (const std::uint8_t covered : m_covered)
    report.overlaps += covered > 1;
  m_squares.resize(std::size_t(m_heights->width()));
  m_inView.clear();
  for (int row = 0; row < m_heights->height(); row++) {
    measureRow(view, row);
    gatherRow(row, report);
  }
  if (m_inView.empty())
    return report;
  report.rms = std::sqrt(report.rms / double(m_inView.size()));
  const auto rank = m_inView.begin() + std::ptrdiff_t(std::ceil(0.999 * double(m_inView.size()))) - 1;
  std::nth_element(m_inView.begin(), rank, m_inView.end());
  report.quantile = std::sqrt(double(*rank));
  return report;
}

void TeScreenError::measureRow(const TeLodView& view, int row) {
  const double y = m_corner.y + row * m_spacing;
  RowView seen{};
  seen.planeCount = view.planeCount;
  for (int i = 0; i < view.planeCount; i++) {
    const glm::dvec4& plane = view.planes[std::size_t(i)];
    seen.planeStart[i] = plane.x * m_corner.x + plane.y * y + plane.z * m_corner.z + plane.w;
    seen.planeColumn[i] = plane.x * m_spacing;
    seen.planeHeight[i] = plane.z * m_heightScale;
  }
  seen.x0 = m_corner.x - view.eye.x;
  seen.dx = m_spacing;
  seen.y2 = (y - view.eye.y) * (y - view.eye.y);
  seen.z0 = m_corner.z - view.eye.z;
  seen.heightScale = m_heightScale;
  seen.pixels = m_heightScale * view.focal;
  seen.perspective = view.perspective;
  squaresOfRow(seen, m_heights->row(row),
               m_deviations.data() + std::size_t(row) * std::size_t(m_heights->width()), m_heights->width(),
               m_squares.data());
}

void TeScreenError::gatherRow(int row, Report& report) {
  const float* heights = m_heights->row(row);
  const float* deviations = m_deviations.data() + std::size_t(row) * std::size_t(m_heights->width());
  double worst = report.worst * report.worst;
  float deepest = 0;
  for (int x = 0; x < m_heights->width(); x++) {
    const double square = m_squares[std::size_t(x)];
    if (!(square >= 0) || TeHeightMap::isMissing(heights[x]))
      continue;
    report.samples++;
    if (deviations[x] < 0) {
      report.uncovered++;
      continue;
    }
    m_inView.push_back(float(square));
    report.rms += square;
    deepest = std::max(deepest, deviations[x]);
    if (square > worst) {
      worst = square;
      report.worst = std::sqrt(square);
      report.worstColumn = x;
      report.worstRow = row;
    }
  }
  report.worstMetres = std::max(report.worstMetres, double(deepest) * m_heightScale);
}
