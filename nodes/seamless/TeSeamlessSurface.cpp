#include "nodes/seamless/TeSeamlessSurface.h"

namespace {

SbVec3f place(const TeSeamlessPlacement& placement, double column, double row, double height) {
  return {float(placement.corner.x + column * placement.spacing),
          float(placement.corner.y + row * placement.spacing),
          float(placement.corner.z + height * placement.heightScale)};
}

} // namespace

SbVec3f TeSeamlessSurface::Triangle::normal() const {
  SbVec3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  normal.normalize();
  return normal;
}

SbVec3f TeSeamlessSurface::position(const TeSeamlessMesh::Vertex& vertex) const {
  return place(m_placement, vertex.column, vertex.row, double(vertex.height));
}

SbBox3f TeSeamlessSurface::box(const TeSeamlessPlacement& placement, const TeSeamlessLayout& layout) {
  return {place(placement, 0, 0, double(placement.range.low)),
          place(placement, layout.resolution(), layout.resolution(), double(placement.range.high))};
}

SbBox3f TeSeamlessSurface::box(const TeSeamlessPatch& patch) const {
  const TeSeamlessBounds* bounds = m_terrain.selector.bounds();
  const TeHeightRange range = bounds ? bounds->range(patch.level, patch.x, patch.y) : m_placement.range;
  const double cells = m_terrain.layout.cells(patch.level);
  return {place(m_placement, patch.x * cells, patch.y * cells, double(range.low)),
          place(m_placement, (patch.x + 1) * cells, (patch.y + 1) * cells, double(range.high))};
}

const std::vector<TeSeamlessSurface::Triangle>& TeSeamlessSurface::triangles(const TeSeamlessPatch& patch) {
  m_samples.clear();
  TeSeamlessMesh::appendPatch(patch, m_terrain.layout, *m_terrain.parts, m_heights, m_samples);
  m_triangles.clear();
  for (const TeSeamlessMesh::Triangle& triangle : m_samples)
    m_triangles.push_back(
        {{position(triangle.a), position(triangle.b), position(triangle.c)}, triangle.strip});
  return m_triangles;
}
