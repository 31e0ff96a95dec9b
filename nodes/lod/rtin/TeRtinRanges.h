#pragma once

#include "generators/TeHeightMap.h"

#include <vector>

/// Lowest and highest sample of every square of 2^k cells a side that lies at a multiple of its size, its rim
/// included, for squares of kLeastCells and more. (2^n + 1)² samples.
///
/// Memory: 0.67 bytes a sample. Cost: a pass over the samples.
class TeRtinRanges {
public:
  static constexpr int kLeastLog = 2;
  static constexpr int kLeastCells = 1 << kLeastLog;

  struct Range {
    float low = 0;
    float high = 0;
  };

  explicit TeRtinRanges(const TeHeightMap& heights);

  /// Of the square of 2^log cells a side that contains the cell (column, row); `log` of at least kLeastLog,
  /// or that of the whole map if this is smaller: smaller ones get the range of the one they lie in.
  const Range& range(int log, int column, int row) const {
    const int level = log < m_leastLog ? 0 : log - m_leastLog;
    const int shift = level + m_leastLog;
    return m_levels[std::size_t(level)][(std::size_t(row) >> shift) * (std::size_t(m_cells) >> shift) +
                                        (std::size_t(column) >> shift)];
  }
  std::size_t bytes() const;

private:
  int m_cells;
  int m_leastLog;
  std::vector<std::vector<Range>> m_levels; ///< from the smallest squares
};
