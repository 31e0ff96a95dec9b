#pragma once

#include <cstdint>
#include <vector>

/// The cache of transformed vertices of a simple graphics processor, simulated: first in, first out. A vertex
/// that is found in it keeps its place.
class TeVertexFifo {
public:
  /// `vertices`: their indices are below that. `size`: of the cache, at least 3.
  TeVertexFifo(std::size_t vertices, int size) : m_size(std::uint32_t(size)), m_entered(vertices, 0) {}

  bool contains(std::uint32_t vertex) const {
    return m_entered[vertex] != 0 && m_misses - m_entered[vertex] < m_size;
  }
  /// Uses a vertex; false if it had to be transformed.
  bool use(std::uint32_t vertex) {
    if (contains(vertex))
      return true;
    m_entered[vertex] = ++m_misses;
    return false;
  }
  std::uint32_t misses() const { return m_misses; }

  /// Average cache miss ratio: vertices transformed for a triangle, of triangles given by three indices each.
  /// From 3 down to vertices / triangles, which is close to 0.5 for large meshes. 0 without triangles.
  static double missesPerTriangle(const std::vector<std::uint32_t>& indices, std::size_t vertices, int size);

private:
  std::uint32_t m_size;
  std::uint32_t m_misses = 0;
  std::vector<std::uint32_t> m_entered; ///< by vertex: the number of the miss that brought it in; 0: none
};
