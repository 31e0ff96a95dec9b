#pragma once

#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "nodes/seamless/TeSeamlessMesh.h"

#include <vector>

/// The heights that a mesh has at the samples of a terrain, in the unit of the samples.
class TeDrawnSurface {
public:
  explicit TeDrawnSurface(int cells);

  /// Replaces what was drawn before. Corners of triangles lie on samples. Cost: one pass over the samples
  /// that are drawn.
  void draw(const std::vector<TeSeamlessMesh::Triangle>& triangles);

  /// NaN where nothing is drawn.
  float height(std::int32_t column, std::int32_t row) const {
    return m_heights[std::size_t(row) * std::size_t(m_side) + std::size_t(column)];
  }

private:
  int m_side;
  std::vector<float> m_heights;
};
