#pragma once

#include "nodes/lod/TeLodMesh.h"

#include <cstdint>
#include <vector>

/// An order of triangles along a Hilbert curve (1891) over the plane: those near in the order are near on the
/// ground, at any scale.
class TeHilbertOrder {
public:
  /// Where a point of a square of 2^16 a side lies along the curve; neighbours along it are neighbours in the
  /// plane. x and y: 0 .. 65535.
  static std::uint32_t along(std::uint32_t x, std::uint32_t y);

  /// Numbers of the triangles, three indices of `vertices` each, by the places of their centres in the
  /// smallest square that holds all vertices. Cost: a sort.
  static std::vector<std::int32_t> create(const std::vector<TeLodVertex>& vertices,
                                          const std::vector<std::uint32_t>& indices);
};
