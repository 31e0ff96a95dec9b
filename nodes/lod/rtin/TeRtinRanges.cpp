#include "nodes/lod/rtin/TeRtinRanges.h"

#include <algorithm>

TeRtinRanges::TeRtinRanges(const TeHeightMap& heights)
    : m_cells(heights.width() - 1), m_leastLog(m_cells < kLeastCells ? 1 : kLeastLog) {
  const int least = 1 << m_leastLog;
  int squares = m_cells / least;
  m_levels.emplace_back(std::size_t(squares) * std::size_t(squares));
  for (int y = 0; y < squares; y++)
    for (int x = 0; x < squares; x++) {
      Range range{heights.at(x * least, y * least), heights.at(x * least, y * least)};
      for (int row = y * least; row <= (y + 1) * least; row++) {
        const float* samples = heights.row(row) + x * least;
        for (int column = 0; column <= least; column++) {
          range.low = std::min(range.low, samples[column]);
          range.high = std::max(range.high, samples[column]);
        }
      }
      m_levels[0][std::size_t(y * squares + x)] = range;
    }
  for (; squares > 1; squares /= 2) {
    const std::vector<Range>& finer = m_levels.back();
    const int half = squares / 2;
    std::vector<Range> level(std::size_t(half) * std::size_t(half));
    for (int y = 0; y < half; y++)
      for (int x = 0; x < half; x++) {
        Range& range = level[std::size_t(y * half + x)];
        range = finer[std::size_t(2 * y * squares + 2 * x)];
        for (const int part : {1, squares, squares + 1}) {
          const Range& other = finer[std::size_t(2 * y * squares + 2 * x + part)];
          range.low = std::min(range.low, other.low);
          range.high = std::max(range.high, other.high);
        }
      }
    m_levels.push_back(std::move(level));
  }
}

std::size_t TeRtinRanges::bytes() const {
  std::size_t bytes = 0;
  for (const std::vector<Range>& level : m_levels)
    bytes += level.capacity() * sizeof(Range);
  return bytes;
}
