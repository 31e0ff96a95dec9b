#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// The dual graph of a triangle mesh: which triangles share an edge. Triangles are numbered as they are
/// given, three indices each; edge i of a triangle goes from corner i to the next.
///
/// An edge of more than two triangles joins pairs of them. Triangles with the same corners are not joined.
/// Cost: a sort of the edges.
class TeDualGraph {
public:
  static constexpr std::int32_t kNone = -1;

  explicit TeDualGraph(const std::vector<std::uint32_t>& indices);

  std::int32_t triangles() const { return std::int32_t(m_neighbours.size()); }
  /// Across the three edges; kNone at a rim.
  const std::array<std::int32_t, 3>& neighbours(std::int32_t triangle) const {
    return m_neighbours[std::size_t(triangle)];
  }

private:
  std::vector<std::array<std::int32_t, 3>> m_neighbours;
};
