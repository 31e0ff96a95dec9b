#include "nodes/lod/geomipmap/TeGeoMipMesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// What a weight leaves of the way to a vertex's own height.
double rest(int weight) { return 1 - double(weight) / TeGeoMipPart::kWhole; }

} // namespace

TeGeoMipMesh::TeGeoMipMesh(const TeLodField& field, const TeGeoMipPatterns& patterns,
                           const TeGeoMipErrors& errors)
    : m_field(field), m_patterns(patterns), m_errors(errors),
      m_rounding(0x1p-22 * std::max(std::fabs(double(field.lowest())), std::fabs(double(field.highest())))) {}

double TeGeoMipMesh::error(const TeGeoMipPart& part) const {
  const TeGeoMipErrors::Patch errors = m_errors.patch(part.x, part.y);
  constexpr std::array<int, 4> kWholeBorders{TeGeoMipPart::kWhole, TeGeoMipPart::kWhole, TeGeoMipPart::kWhole,
                                             TeGeoMipPart::kWhole};
  if (part.weight == TeGeoMipPart::kWhole && part.borderWeights == kWholeBorders) {
    float error = errors.regular(part.level);
    for (std::size_t side = 0; side < 4; side++)
      error = std::max(error, errors.stitched(part.level, TeGeoMipSide(side), part.sides[side]));
    return double(error);
  }
  const auto moved = [&](int level, int weight) {
    return level + 1 < m_patterns.levels() ? rest(weight) * double(errors.midpoint(level + 1)) : 0;
  };
  const double regular = double(errors.regular(part.level));
  const double inside = moved(part.level, part.weight);
  double error = regular;
  double most = inside;
  if (inside > 0) // between the surfaces of two levels
    error += std::min(inside, rest(part.weight) * (double(errors.regular(part.level + 1)) - regular));
  for (std::size_t side = 0; side < 4; side++) {
    const int border = part.sides[side];
    const double onBorder = moved(border, part.borderWeights[side]);
    most = std::max(most, onBorder);
    if (border == part.level) {
      if (part.borderWeights[side] != part.weight)
        error = std::max(error, regular + std::max(inside, onBorder));
      continue;
    }
    double farthest = std::max(inside, onBorder);
    for (const std::size_t next : {(side + 1) % 4, (side + 3) % 4})
      if (part.sides[next] == part.level)
        farthest = std::max(farthest, moved(part.level, part.borderWeights[next]));
    error = std::max(error, double(errors.stitched(part.level, TeGeoMipSide(side), border)) + farthest);
  }
  return most > 0 ? error + m_rounding : error;
}

// (x, y) in samples of the patch.
TeLodVertex TeGeoMipMesh::vertex(const TeGeoMipPart& part, int x, int y) const {
  const int patchCells = m_patterns.patchCells();
  const int side = y == 0 ? 0 : x == patchCells ? 1 : y == patchCells ? 2 : x == 0 ? 3 : -1;
  const int level = side < 0 ? part.level : part.sides[std::size_t(side)];
  const int weight = side < 0 ? part.weight : part.borderWeights[std::size_t(side)];
  const int step = 2 << level; // of the next coarser level
  const int dx = x % step, dy = y % step;
  const int column = part.x * patchCells + x, row = part.y * patchCells + y;
  TeLodVertex vertex = m_field.vertex(column, row);
  const bool isLeftOut = (dx == 0 || 2 * dx == step) && (dy == 0 || 2 * dy == step) && (dx != 0 || dy != 0);
  if (weight == TeGeoMipPart::kWhole || !isLeftOut || step > patchCells)
    return vertex;
  const double coarser =
      0.5 * (double(m_field.height(column - dx, row - dy)) + double(m_field.height(column + dx, row + dy)));
  vertex.height = float(double(vertex.height) + rest(weight) * (coarser - double(vertex.height)));
  return vertex;
}

void TeGeoMipMesh::append(const TeGeoMipPart& part, TeLodMesh& mesh) const {
  const auto first = std::uint32_t(mesh.vertices.size());
  const int cells = m_patterns.cells(part.level);
  for (int y = 0; y <= cells; y++)
    for (int x = 0; x <= cells; x++)
      mesh.vertices.push_back(vertex(part, x << part.level, y << part.level));
  m_patterns.append(part.level, part.sides, first, mesh.indices);
}
