#pragma once

#include <cstdint>
#include <vector>

/// Checks that triangles over a grid of samples leave no crack: counts edges that are not shared by exactly
/// two triangles.
///
/// Vertices are numbered row·(resolution + 1) + column of a square of resolution × resolution cells, up to
/// 32768. Memory: 24 bytes a triangle, used again.
class TeWatertight {
public:
  explicit TeWatertight(int resolution) : m_resolution(resolution) {}

  void clear();
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// Edges with one triangle that do not lie on the rim of the square, plus edges with more than two. Each
  /// gap, overlap and T-junction makes some. Cost: a sort.
  std::int64_t cracks();
  /// Twice the area of all triangles in cells; a triangle that is not counter-clockwise counts as negative.
  std::int64_t doubleArea() const { return m_doubleArea; }
  /// Triangles of no area, or seen from below.
  std::int64_t slivers() const { return m_slivers; }
  bool coversSquare() const { return m_doubleArea == 2 * std::int64_t(m_resolution) * m_resolution; }

private:
  bool onRim(std::uint32_t a, std::uint32_t b) const;

  int m_resolution;
  std::int64_t m_doubleArea = 0;
  std::int64_t m_slivers = 0;
  std::vector<std::uint64_t> m_edges;
};
