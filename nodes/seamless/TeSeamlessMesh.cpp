#include "nodes/seamless/TeSeamlessMesh.h"

#include <algorithm>

namespace {

/// Heights of the vertices of a patch, morphed as the vertex shader does.
class PatchHeights {
public:
  PatchHeights(const TeSeamlessPatch& patch, const TeSeamlessLayout& layout, const TeSeamlessHeights& heights)
      : m_layout(layout), m_heights(heights), m_cellsLog(layout.cellsLog(patch.level)),
        m_column(patch.x << m_cellsLog), m_row(patch.y << m_cellsLog) {
    for (std::size_t side = 0; side < 4; side++) {
      m_details[side] = patch.detail[side];
      m_details[TePartVertex::kDiagonal + side] = std::max(patch.detail[side], patch.detail[(side + 1) % 4]);
    }
    for (std::size_t chain = 0; chain < 8; chain++)
      m_heightLevels[chain] =
          layout.resolutionLog() - layout.spacingLog(patch.level, teDetailResolution(m_details[chain]));
  }

  TeSeamlessMesh::Vertex vertex(const TePartVertex& vertex) const {
    TeSeamlessMesh::Vertex result{column(vertex.x), row(vertex.y), at(vertex.x, vertex.y, vertex.chain)};
    const float detail = m_details[vertex.chain];
    const std::uint8_t weight = teDetailWeight(detail);
    if (weight == 255)
      return result;
    const int step = m_layout.maxResolution() / m_layout.resolutionOf(teDetailResolution(detail));
    const int dx = (vertex.x / step) % 2 * step;
    const int half = m_layout.maxResolution() / 2;
    int dy = (vertex.y / step) % 2 * step;
    if (dx == 0 && dy == 0)
      return result;
    // The cells' diagonals point to the centre of the patch.
    if ((vertex.x < half) != (vertex.y < half))
      dy = -dy;
    const float middle = 0.5f * (at(vertex.x - dx, vertex.y - dy, vertex.chain) +
                                 at(vertex.x + dx, vertex.y + dy, vertex.chain));
    result.height = middle + float(weight) * (1.0f / 255.0f) * (result.height - middle);
    return result;
  }

private:
  /// From the patch's corner.
  std::int32_t samples(int place) const {
    return std::int32_t((std::int64_t(place) << m_cellsLog) >> m_layout.maxResolutionLog());
  }
  std::int32_t column(int x) const { return m_column + samples(x); }
  std::int32_t row(int y) const { return m_row + samples(y); }
  float at(int x, int y, std::uint16_t chain) const {
    return m_heights.height(column(x), row(y), m_heightLevels[chain]);
  }

  const TeSeamlessLayout& m_layout;
  const TeSeamlessHeights& m_heights;
  int m_cellsLog;
  std::int32_t m_column;
  std::int32_t m_row;
  float m_details[8]; ///< by TePartVertex::chain
  int m_heightLevels[8];
};

void appendPart(const TePart& part, bool strip, const TeSeamlessParts& parts, const PatchHeights& heights,
                std::vector<TeSeamlessMesh::Triangle>& triangles) {
  const auto vertex = [&](int index) {
    const std::size_t number = std::size_t(part.firstVertex) + parts.indices()[std::size_t(index)];
    return heights.vertex(parts.vertices()[number]);
  };
  for (int i = part.firstIndex; i < part.firstIndex + part.count; i += 3)
    triangles.push_back({vertex(i), vertex(i + 1), vertex(i + 2), strip});
}

} // namespace

void TeSeamlessMesh::appendPatch(const TeSeamlessPatch& patch, const TeSeamlessLayout& layout,
                                 const TeSeamlessParts& parts, const TeSeamlessHeights& heights,
                                 std::vector<Triangle>& triangles) {
  const PatchHeights patchHeights(patch, layout, heights);
  for (int side = 0; side < 4; side++) {
    const int a = patch.resolution(side), b = patch.resolution((side + 1) % 4);
    appendPart(parts.tile(side, a), false, parts, patchHeights, triangles);
    appendPart(parts.strip(side, a, b), true, parts, patchHeights, triangles);
  }
}
