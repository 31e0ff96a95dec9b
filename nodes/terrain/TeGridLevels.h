#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// Coarser triangulations of a whole grid of vertices, by indices of its own vertices (index = row * columns
/// + column): they need no further vertices, and are the same for all grids of a size.
///
/// All vertices of the rim stay in every level, so that whatever lies beside the grid fits without knowing
/// its level. Level l has of the inside only every 2^l-th column and row, split along the SW-NE diagonal as
/// level 0 is, and a ring of triangles between the outermost of them and the rim. The last level has a
/// single vertex, or a single line of them, inside. A grid that is 3 vertices wide, which is all rim but for
/// its middle line, has one level, without that line.
///
/// Triangles are counter-clockwise seen from above and cover the grid exactly once. Of 31 × 31 vertices (a
/// patch of 32 cells a side): 1800 triangles, then 568, 216, 136 and 120.
class TeGridLevels {
public:
  TeGridLevels(int columns, int rows);

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  /// Without level 0; 0 where the grid is too small to have any.
  int count() const { return int(m_levels.size()); }
  /// Three a triangle; levels 1 .. count().
  const std::vector<std::uint32_t>& indices(int level) const { return m_levels[std::size_t(level - 1)]; }
  std::int64_t triangles(int level) const { return std::int64_t(indices(level).size() / 3); }
  std::size_t bytes() const;

private:
  /// The columns or rows that a level has inside: first, first + step, .. last.
  struct Lines {
    int first;
    int last;
  };
  static Lines linesOf(int vertices, int step);
  std::uint32_t vertex(int column, int row) const { return std::uint32_t(row * m_columns + column); }
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void addLevel(int step);
  void addRing(Lines columns, Lines rows, int step);
  void addStrip();

  int m_columns;
  int m_rows;
  std::vector<std::vector<std::uint32_t>> m_levels;
};
