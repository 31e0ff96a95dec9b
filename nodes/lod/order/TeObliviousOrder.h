#pragma once

#include <cstdint>
#include <vector>

/// An order of triangles for caches of vertices of any size: the mesh is cut into halves of nearly as many
/// triangles that share few edges, one half after the other, each ordered the same way (document 003:
/// balanced edge cut of the dual graph, halves adjacent; after Bogomjakov and Gotsman, Universal rendering
/// sequences for transparent vertex caching of progressive meshes, 2002).
///
/// The halves grow from two ends of the mesh, triangle by triangle across edges, always the one that has most
/// edges with what is there; the second half then begins at the cut.
class TeObliviousOrder {
public:
  /// Numbers of the triangles, three indices each. Cost: 0.5 to 4 µs a triangle: log₂ of
  /// them halvings.
  static std::vector<std::int32_t> create(const std::vector<std::uint32_t>& indices);
};
