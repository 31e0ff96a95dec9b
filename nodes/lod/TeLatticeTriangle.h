#pragma once

#include "nodes/lod/TeLodMesh.h"

#include <cstdint>
#include <utility>

/// The samples that a triangle with corners on samples covers, row by row, in whole numbers.
class TeLatticeTriangle {
public:
  /// Of either orientation; with an area.
  TeLatticeTriangle(const TeLodVertex& a, const TeLodVertex& b, const TeLodVertex& c)
      : m_low(&a), m_middle(&b), m_high(&c) {
    if (m_low->row > m_middle->row)
      std::swap(m_low, m_middle);
    if (m_middle->row > m_high->row)
      std::swap(m_middle, m_high);
    if (m_low->row > m_middle->row)
      std::swap(m_low, m_middle);
    const Edge whole{m_low, m_high};
    m_middleRight =
        (std::int64_t(m_middle->column) - m_low->column) * whole.rows() > whole.part(m_middle->row);
  }

  std::int32_t firstRow() const { return m_low->row; }
  std::int32_t lastRow() const { return m_high->row; }

  struct Span {
    std::int32_t first = 0; ///< column; the span is empty if it is more than `last`
    std::int32_t last = 0;
    /// Of samples on edges, the triangle that counts them is the one to the east, or the north, of the edge:
    /// first .. openEnd - 1 belong to no other triangle of a mesh.
    std::int32_t openEnd = 0;
  };
  Span span(std::int32_t row) const {
    const Edge whole{m_low, m_high};
    const Edge broken = row < m_middle->row   ? Edge{m_low, m_middle}
                        : row > m_middle->row ? Edge{m_middle, m_high}
                                              : Edge{m_middle, m_middle};
    const Edge& left = m_middleRight ? whole : broken;
    const Edge& right = m_middleRight ? broken : whole;
    return {std::int32_t(left.ceil(row)), std::int32_t(right.floor(row)),
            row < m_high->row ? std::int32_t(right.ceil(row)) : 0};
  }

private:
  static std::int64_t floorDivide(std::int64_t number, std::int64_t positive) {
    const std::int64_t quotient = number / positive;
    return quotient * positive > number ? quotient - 1 : quotient;
  }

  /// Where an edge crosses rows: column = whole + part / rows, exactly.
  struct Edge {
    const TeLodVertex* low;
    const TeLodVertex* high;

    std::int64_t rows() const { return std::int64_t(high->row) - low->row; }
    std::int64_t part(std::int64_t row) const {
      return (std::int64_t(high->column) - low->column) * (row - low->row);
    }
    std::int64_t floor(std::int64_t row) const {
      return low->column + (rows() > 0 ? floorDivide(part(row), rows()) : 0);
    }
    std::int64_t ceil(std::int64_t row) const {
      return low->column + (rows() > 0 ? -floorDivide(-part(row), rows()) : 0);
    }
  };

  const TeLodVertex* m_low;
  const TeLodVertex* m_middle;
  const TeLodVertex* m_high;
  bool m_middleRight = false; ///< the third corner lies east of the edge from the lowest to the highest
};
