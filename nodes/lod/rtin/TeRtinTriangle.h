#pragma once

#include <algorithm>
#include <cstdint>

/// A right triangle of a triangulation that halves triangles at the middle of their hypotenuse, over a square
/// of 2^n × 2^n cells. Corners counter-clockwise from above; a-b is the hypotenuse.
///
/// Every one is either half a square of 2^k cells a side, which lies at a multiple of its size, or one of the
/// four parts of such a square around its centre. The diagonals of squares end in the centre of the square of
/// twice the size, so that of (i, j), in squares, rises to the east if i + j is even.
class TeRtinTriangle {
public:
  struct Corner {
    std::int32_t column = 0;
    std::int32_t row = 0;
  };

  /// The two halves of the whole square; `half` 0 is that in the south-east.
  static TeRtinTriangle root(int cellsLog, int half) {
    const std::int32_t cells = 1 << cellsLog;
    if (half == 0)
      return {{cells, cells}, {0, 0}, {cells, 0}, cellsLog, true};
    return {{0, 0}, {cells, cells}, {0, cells}, cellsLog, true};
  }

  const Corner& a() const { return m_a; }
  const Corner& b() const { return m_b; }
  const Corner& apex() const { return m_apex; }
  /// log₂ of the size of its square.
  int sizeLog() const { return m_sizeLog; }
  bool isHalfSquare() const { return m_isHalfSquare; }
  /// Half a cell: it cannot be halved at a sample.
  bool isSmallest() const { return m_sizeLog == 0; }

  std::int32_t lowColumn() const { return std::min({m_a.column, m_b.column, m_apex.column}); }
  std::int32_t highColumn() const { return std::max({m_a.column, m_b.column, m_apex.column}); }
  std::int32_t lowRow() const { return std::min({m_a.row, m_b.row, m_apex.row}); }
  std::int32_t highRow() const { return std::max({m_a.row, m_b.row, m_apex.row}); }

  /// Of the hypotenuse: the vertex that halves the triangle.
  Corner middle() const { return {(m_a.column + m_b.column) / 2, (m_a.row + m_b.row) / 2}; }
  TeRtinTriangle firstHalf() const { return {m_apex, m_a, middle(), nextLog(), !m_isHalfSquare}; }
  TeRtinTriangle secondHalf() const { return {m_b, m_apex, middle(), nextLog(), !m_isHalfSquare}; }

  /// The other corners of the two triangles that a vertex halves: without them it cannot be. Two of them, or
  /// one that is given twice, at the rim. `vertex` is no corner of the whole square.
  struct Needed {
    Corner first;
    Corner second;
  };
  static Needed neededFor(const Corner& vertex, std::int32_t cells) {
    const std::int32_t bits = vertex.column | vertex.row;
    const std::int32_t half = bits & -bits; ///< distance to the ends of its edge, along an axis
    const bool oddColumn = (vertex.column & half) != 0, oddRow = (vertex.row & half) != 0;
    if (oddColumn && oddRow) {
      // The centre of a square: corners beside its diagonal.
      const bool risesEast = ((vertex.column ^ vertex.row) & (2 * half)) == 0;
      const std::int32_t toEast = risesEast ? half : -half;
      return {{vertex.column + toEast, vertex.row - half}, {vertex.column - toEast, vertex.row + half}};
    }
    Corner first = vertex, second = vertex;
    std::int32_t Corner::*across = oddColumn ? &Corner::row : &Corner::column;
    first.*across -= half;
    second.*across += half;
    if (first.*across < 0)
      first = second;
    if (second.*across > cells)
      second = first;
    return {first, second};
  }

private:
  TeRtinTriangle(const Corner& a, const Corner& b, const Corner& apex, int sizeLog, bool isHalfSquare)
      : m_a(a), m_b(b), m_apex(apex), m_sizeLog(sizeLog), m_isHalfSquare(isHalfSquare) {}
  /// Parts around the centre of a square belong to it; their halves are half squares of half the size.
  int nextLog() const { return m_isHalfSquare ? m_sizeLog : m_sizeLog - 1; }

  Corner m_a;
  Corner m_b;
  Corner m_apex;
  std::int32_t m_sizeLog;
  bool m_isHalfSquare;
};
