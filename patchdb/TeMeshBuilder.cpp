#include "patchdb/TeMeshBuilder.h"

#include "generators/TeHeightMap.h"
#include "patchdb/TeSurfaceNormals.h"

#include <algorithm>
#include <cmath>

TeMeshBuilder::TeMeshBuilder(const TeLattice& lattice, const TeMeshBlock& block, TePatchMesh mesh)
    : m_lattice(lattice), m_block(block), m_mesh(std::move(mesh)),
      m_scale(teMeshScale(lattice, m_mesh.key.level)) {
  if (block.columns < 2 || block.rows < 2) {
    m_row = block.rows;
    return;
  }
  const std::int64_t step = std::int64_t(1) << m_mesh.key.level;
  const std::size_t columns = std::size_t(block.columns);
  const std::size_t rows = std::size_t(block.rows);
  m_mesh.columns = block.columns;
  m_mesh.rows = block.rows;
  m_mesh.origin = {coordinate(block.first.x + (block.columns / 2) * step),
                   coordinate(block.first.y + (block.rows / 2) * step), 0.0};
  m_localX.resize(columns);
  for (int x = 0; x < block.columns; ++x)
    m_localX[std::size_t(x)] = float(coordinate(block.first.x + x * step) - m_mesh.origin.x);
  // Room without touching it, which is done row by row.
  m_mesh.positions.reserve(columns * rows);
  m_mesh.normals.reserve(columns * rows);
  m_mesh.strips.reserve((rows - 1) * (2 * columns + 1));
}

double TeMeshBuilder::coordinate(std::int64_t sample) const {
  return std::nearbyint(m_lattice.position(sample) * m_scale) / m_scale;
}

bool TeMeshBuilder::step(TeAllowance& allowance) {
  const int rows = std::max(1, kVerticesPerUnit / std::max(1, m_block.columns));
  while (m_row < m_block.rows) {
    const int end = std::min(m_row + rows, m_block.rows);
    addRows(m_row, end);
    m_row = end;
    if (!allowance.spend())
      break;
  }
  return m_row >= m_block.rows;
}

TePatchMesh TeMeshBuilder::finish() {
  TeAllowance all = TeAllowance::unlimited();
  step(all);
  return take();
}

void TeMeshBuilder::addRows(int from, int to) {
  const std::int64_t step = std::int64_t(1) << m_mesh.key.level;
  const std::size_t columns = std::size_t(m_block.columns);
  const float* heights = m_block.heights + std::ptrdiff_t(from) * m_block.stride;
  m_mesh.positions.resize(std::size_t(to) * columns);
  glm::vec3* position = &m_mesh.positions[std::size_t(from) * columns];
  const float* row = heights;
  for (int y = from; y < to; ++y, row += m_block.stride) {
    const float localY = float(coordinate(m_block.first.y + y * step) - m_mesh.origin.y);
    for (std::size_t x = 0; x < columns; ++x)
      *position++ = {m_localX[x], localY, TeHeightMap::isMissing(row[x]) ? 0.0f : row[x]};
  }
  m_mesh.normals.resize(std::size_t(to) * columns);
  teGridNormals(heights, m_block.stride, m_block.columns, to - from, m_lattice.spacing() * double(step),
                m_block.missing, &m_mesh.normals[std::size_t(from) * columns]);
  for (int y = from; y < std::min(to, m_block.rows - 1); ++y)
    m_block.missing ? addStripWithHoles(y) : addStrip(y);
}

// A strip for each row of cells. North before south in each pair makes the diagonal run south-west to
// north-east and the triangles counter-clockwise.

void TeMeshBuilder::addStrip(int y) {
  const std::int32_t columns = m_block.columns;
  const std::size_t length = 2 * std::size_t(columns) + 1;
  m_mesh.strips.resize(std::size_t(y + 1) * length);
  std::int32_t* out = &m_mesh.strips[std::size_t(y) * length];
  for (std::int32_t south = y * columns; south < (y + 1) * columns; ++south) {
    *out++ = south + columns;
    *out++ = south;
  }
  *out = -1;
}

void TeMeshBuilder::addStripWithHoles(int y) {
  const auto missing = [&](int atX, int atY) {
    return TeHeightMap::isMissing(m_block.heights[std::ptrdiff_t(atY) * m_block.stride + atX]);
  };
  std::vector<std::int32_t>& strips = m_mesh.strips;
  bool open = false;
  for (int x = 0; x + 1 < m_block.columns; ++x) {
    const std::int32_t south = y * m_block.columns + x;
    const std::int32_t north = south + m_block.columns;
    if (missing(x, y) || missing(x + 1, y) || missing(x, y + 1) || missing(x + 1, y + 1)) {
      if (open)
        strips.push_back(-1);
      open = false;
      continue;
    }
    if (!open)
      strips.insert(strips.end(), {north, south});
    strips.insert(strips.end(), {north + 1, south + 1});
    open = true;
  }
  if (open)
    strips.push_back(-1);
}
