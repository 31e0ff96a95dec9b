#pragma once

#include <cstdint>
#include <vector>

/// A vertex over sample (column, row) of a square of samples, of a height in their unit: that of the sample,
/// but for vertices that are morphed or stand at the lower end of a skirt.
struct TeLodVertex {
  std::int32_t column = 0;
  std::int32_t row = 0;
  float height = 0;
};

/// Triangles of a LOD method in the memory of the CPU.
struct TeLodMesh {
  std::vector<TeLodVertex> vertices;
  std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise from above
  /// Three a triangle of walls that hide what is between surfaces that do not fit (Chunked LOD), seen from
  /// outside; they are no part of the surface.
  std::vector<std::uint32_t> skirts;

  std::int64_t triangles() const { return std::int64_t(indices.size() + skirts.size()) / 3; }
  void clear() {
    vertices.clear();
    indices.clear();
    skirts.clear();
  }
};
