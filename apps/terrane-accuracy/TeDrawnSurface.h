#pragma once

#include "nodes/lod/TeLodMesh.h"

#include <cstddef>
#include <vector>

/// The heights that a mesh has at the samples of a terrain, in the unit of the samples.
class TeDrawnSurface {
public:
  explicit TeDrawnSurface(int cells);

  /// Replaces what was drawn before, without skirts. Corners of triangles lie on samples. Cost: one pass over
  /// the samples that are drawn.
  void draw(const TeLodMesh& mesh);

  /// NaN where nothing is drawn.
  float height(std::int32_t column, std::int32_t row) const {
    return m_heights[std::size_t(row) * std::size_t(m_side) + std::size_t(column)];
  }
  /// Of all samples of a row.
  const float* row(std::int32_t row) const { return &m_heights[std::size_t(row) * std::size_t(m_side)]; }

private:
  int m_side;
  std::vector<float> m_heights;
};
