#pragma once

#include "generators/TeHeightMap.h"

#include <cstddef>
#include <vector>

/// Lowest and highest samples of square blocks of a patch's cells, for rays to pass over: blocks of 8×8
/// cells, of 8×8 such blocks, and so on until one block is the whole patch. A block's samples are those of
/// its cells' corners, so neighbours share a row; blocks at the east and north may be smaller. One with a
/// missing sample reaches from -infinity to infinity.
///
/// Memory: 8 bytes a block, 0.13 a sample. Cost: one pass over the samples.
class TeHeightBlocks {
public:
  static constexpr int kShift = 3;
  static constexpr int kCells = 1 << kShift; ///< a side, of a block of the level below

  struct Range {
    float low = 0;
    float high = 0;
  };

  /// Of nothing: no levels.
  TeHeightBlocks() = default;
  /// `missing`: whether there may be missing samples. At least 2×2 samples, else as of nothing.
  TeHeightBlocks(const TeHeightMap& heights, bool missing);

  /// Level 1 has blocks of 8 cells a side, level 2 of 64 …; 0 if there are none. The last has one block.
  int levels() const { return int(m_levels.size()); }
  /// Block (x, y) of a level 1 .. levels(): cells x·8^level .. (x+1)·8^level - 1.
  const Range& range(int level, int x, int y) const {
    const Level& blocks = m_levels[std::size_t(level - 1)];
    return m_ranges[blocks.first + std::size_t(y) * std::size_t(blocks.columns) + std::size_t(x)];
  }
  std::size_t bytes() const {
    return m_ranges.capacity() * sizeof(Range) + m_levels.capacity() * sizeof(Level);
  }

private:
  struct Level {
    std::size_t first = 0;
    int columns = 0;
    int rows = 0;
  };

  void measureSamples(const TeHeightMap& heights, bool missing);
  void join(const Level& fine, const Level& coarse);

  std::vector<Level> m_levels;
  std::vector<Range> m_ranges; ///< by level, then row
};
