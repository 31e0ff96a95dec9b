#include "nodes/terrain/TeMeshModelJob.h"

#include "nodes/terrain/TeMeshVertices.h"

#include <algorithm>
#include <cassert>

TeMeshModelJob::TeMeshModelJob(TePatchMeshPtr mesh, const TeSurfaceColours& colours,
                               std::shared_ptr<TeMeshDrawing> drawing)
    : m_mesh(std::move(mesh)), m_surfaceColours(colours), m_drawing(std::move(drawing)) {
  assert(m_mesh && m_mesh->normals.size() == m_mesh->positions.size());
  m_colours.reserve(m_mesh->positions.size());
  if (m_drawing->pixelError() > 0 && teIsWholeGrid(*m_mesh))
    m_errors.emplace(*m_mesh, m_drawing->gridLevels(m_mesh->columns, m_mesh->rows));
}

bool TeMeshModelJob::step(TeAllowance& allowance) {
  const std::size_t count = m_mesh->positions.size();
  while (m_colours.size() < count) {
    const std::size_t end = std::min(count, m_colours.size() + kVerticesPerUnit);
    for (std::size_t i = m_colours.size(); i < end; i++)
      m_colours.push_back(m_surfaceColours.packed(m_mesh->positions[i].z, m_mesh->normals[i]));
    if (!allowance.spend())
      return m_colours.size() == count && !m_errors;
  }
  return !m_errors || m_errors->step(allowance);
}

TeNodePtr<SoTeTerrainMesh> TeMeshModelJob::take() {
  assert(m_colours.size() == m_mesh->positions.size());
  TeNodePtr<SoTeTerrainMesh> node(new SoTeTerrainMesh);
  node->setMesh(std::move(m_mesh), std::move(m_colours), std::move(m_drawing));
  if (m_errors)
    node->setLevelErrors(m_errors->take());
  return node;
}
