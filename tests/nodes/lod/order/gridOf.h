#pragma once

#include "nodes/lod/TeLodMesh.h"

#include <cstdint>

/// A mesh of cells × cells cells, row by row, as most programs make it.
inline TeLodMesh gridOf(int cells) {
  TeLodMesh mesh;
  for (int row = 0; row <= cells; row++)
    for (int column = 0; column <= cells; column++)
      mesh.vertices.push_back({column, row, 0});
  const std::uint32_t width = std::uint32_t(cells) + 1;
  for (std::uint32_t row = 0; row + 1 < width; row++)
    for (std::uint32_t column = 0; column + 1 < width; column++) {
      const std::uint32_t southWest = row * width + column, northWest = southWest + width;
      mesh.indices.insert(mesh.indices.end(), {southWest, southWest + 1, northWest + 1});
      mesh.indices.insert(mesh.indices.end(), {southWest, northWest + 1, northWest});
    }
  return mesh;
}
