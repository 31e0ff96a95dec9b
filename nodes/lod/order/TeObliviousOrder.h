#pragma once

#include <cstdint>
#include <vector>

/// An order of triangles for caches of vertices of any size: the mesh is cut into halves of equally many
/// triangles that share few edges, one half after the other, each ordered the same way (document 003:
/// balanced edge cut of the dual graph, halves adjacent; after Bogomjakov and Gotsman, Universal rendering
/// sequences for transparent vertex caching of progressive meshes, 2002).
///
/// A half grows from one end of the mesh, triangle by triangle across edges, always the one that adds fewest
/// cut edges, until it has half of the triangles; the second half begins at the cut.
class TeObliviousOrder {
public:
  /// Numbers of the triangles, three indices each. Cost: about 50 ns a triangle for each of log₂ halvings.
  static std::vector<std::int32_t> create(const std::vector<std::uint32_t>& indices);
};
