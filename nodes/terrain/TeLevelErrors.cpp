#include "nodes/terrain/TeLevelErrors.h"

#include "nodes/lod/TeTriangleDeviation.h"

#include <algorithm>
#include <cassert>

TeLevelErrors::TeLevelErrors(const TePatchMesh& mesh, std::shared_ptr<const TeGridLevels> levels)
    : m_levels(std::move(levels)), m_errors(std::size_t(m_levels->count()) + 1, 0.0f) {
  assert(mesh.columns == m_levels->columns() && mesh.rows == m_levels->rows());
  if (m_levels->count() == 0)
    return;
  TeResult<TeHeightMap> heights = TeHeightMap::create(mesh.columns, mesh.rows);
  assert(heights); // the mesh has had room, too
  m_heights = std::move(*heights);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    m_heights.data()[i] = mesh.positions[i].z;
}

bool TeLevelErrors::step(TeAllowance& allowance) {
  const int columns = m_levels->columns();
  const auto vertex = [&](std::uint32_t index) {
    return TeLodVertex{std::int32_t(index) % columns, std::int32_t(index) / columns, m_heights.data()[index]};
  };
  while (m_level <= m_levels->count()) {
    const std::vector<std::uint32_t>& indices = m_levels->indices(m_level);
    const std::size_t end = std::min(indices.size(), m_next + 3 * kTrianglesPerUnit);
    float& worst = m_errors[std::size_t(m_level)];
    for (; m_next < end; m_next += 3)
      worst = std::max(worst, teTriangleDeviation(m_heights, vertex(indices[m_next]),
                                                  vertex(indices[m_next + 1]), vertex(indices[m_next + 2])));
    if (m_next == indices.size()) {
      m_next = 0;
      ++m_level;
    }
    if (!allowance.spend())
      break;
  }
  return m_level > m_levels->count();
}
