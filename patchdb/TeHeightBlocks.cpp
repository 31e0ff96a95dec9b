#include "patchdb/TeHeightBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr int kSide = TeHeightBlocks::kCells;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

int blocksOf(int cells) { return (cells + kSide - 1) / kSide; }

float lower(float a, float b) { return a < b ? a : b; }
float higher(float a, float b) { return a > b ? a : b; }

/// A whole block without missing samples: eight columns side by side, then the ninth.
TeHeightBlocks::Range wholeBlock(const float* samples, std::size_t stride) {
  float low[kSide], high[kSide];
  for (int i = 0; i < kSide; ++i)
    low[i] = high[i] = samples[i];
  float lastLow = samples[kSide], lastHigh = samples[kSide];
  for (int row = 1; row <= kSide; ++row) {
    samples += stride;
    for (int i = 0; i < kSide; ++i)
      low[i] = lower(samples[i], low[i]);
    for (int i = 0; i < kSide; ++i)
      high[i] = higher(samples[i], high[i]);
    lastLow = lower(samples[kSide], lastLow);
    lastHigh = higher(samples[kSide], lastHigh);
  }
  for (int i = 0; i < kSide; ++i) {
    lastLow = lower(low[i], lastLow);
    lastHigh = higher(high[i], lastHigh);
  }
  return {lastLow, lastHigh};
}

/// Of columns+1 by rows+1 samples, some of which may be missing.
TeHeightBlocks::Range anyBlock(const float* samples, std::size_t stride, int columns, int rows) {
  TeHeightBlocks::Range range{kInfinity, -kInfinity};
  for (int y = 0; y <= rows; ++y, samples += stride)
    for (int x = 0; x <= columns; ++x) {
      if (TeHeightMap::isMissing(samples[x]))
        return {-kInfinity, kInfinity};
      range = {lower(samples[x], range.low), higher(samples[x], range.high)};
    }
  return range;
}

} // namespace

TeHeightBlocks::TeHeightBlocks(const TeHeightMap& heights, bool missing) {
  if (heights.width() < 2 || heights.height() < 2)
    return;
  std::size_t count = 0;
  int levels = 0;
  int columns = heights.width() - 1, rows = heights.height() - 1;
  do {
    columns = blocksOf(columns);
    rows = blocksOf(rows);
    count += std::size_t(columns) * std::size_t(rows);
    ++levels;
  } while (columns > 1 || rows > 1);
  m_ranges.resize(count);
  m_levels.resize(std::size_t(levels));
  columns = heights.width() - 1;
  rows = heights.height() - 1;
  std::size_t first = 0;
  for (Level& level : m_levels) {
    columns = blocksOf(columns);
    rows = blocksOf(rows);
    level = {first, columns, rows};
    first += std::size_t(columns) * std::size_t(rows);
  }
  measureSamples(heights, missing);
  for (std::size_t level = 1; level < m_levels.size(); ++level)
    join(m_levels[level - 1], m_levels[level]);
}

void TeHeightBlocks::measureSamples(const TeHeightMap& heights, bool missing) {
  const int columns = heights.width() - 1, rows = heights.height() - 1;
  const std::size_t stride = std::size_t(heights.width());
  std::size_t at = 0;
  for (int y = 0; y < rows; y += kSide)
    for (int x = 0; x < columns; x += kSide, ++at) {
      const float* samples = heights.row(y) + x;
      const int width = std::min(kSide, columns - x), height = std::min(kSide, rows - y);
      m_ranges[at] = !missing && width == kSide && height == kSide ? wholeBlock(samples, stride)
                                                                   : anyBlock(samples, stride, width, height);
    }
}

void TeHeightBlocks::join(const Level& fine, const Level& coarse) {
  std::fill_n(m_ranges.begin() + std::ptrdiff_t(coarse.first), coarse.columns * coarse.rows,
              Range{kInfinity, -kInfinity});
  for (int y = 0; y < fine.rows; ++y)
    for (int x = 0; x < fine.columns; ++x) {
      const Range& part = m_ranges[fine.first + std::size_t(y * fine.columns + x)];
      Range& whole = m_ranges[coarse.first + std::size_t((y >> kShift) * coarse.columns + (x >> kShift))];
      whole = {lower(part.low, whole.low), higher(part.high, whole.high)};
    }
}
