#pragma once

#include "nodes/clipmap/TePyramidTiles.h"
#include "nodes/clipmap/TeSampleRect.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The samples of one level that a clipmap holds: a square image in which sample (x, y) has the place
/// (x mod side, y mod side), so that samples that come in take the places of those that go.
class TeClipImage {
public:
  /// Throws std::bad_alloc.
  TeClipImage(int level, int side, int bytesPerSample);

  int level() const { return m_level; }
  std::size_t rowBytes() const { return std::size_t(m_side) * std::size_t(m_bytesPerSample); }
  /// What it has; its size is that of the window, or less while it is being filled.
  const TeSampleRect& held() const { return m_held; }
  /// Whether it has a window of its own size.
  bool isWhole() const { return m_held.columns == m_side && m_held.rows == m_side; }
  /// Whether reading has failed; then it has nothing.
  bool hasFailed() const { return m_hasFailed; }

  /// Fills it with a whole level that is smaller than its side or equal. `from`: the level to be read, this
  /// one or a higher one, of which every 2^n-th sample and row is taken.
  TeStatus loadWhole(TePyramidTiles& tiles, int from);

  /// Drops all that is not in `window`, of side × side samples, and reads whole columns and rows of it, as
  /// many as have at most `samples` samples together; returns that number. Appends the places that were
  /// written to, in rectangles that do not cross the image's border. Error: a file that cannot be read; the
  /// image has then failed.
  TeResult<std::int64_t> follow(TePyramidTiles& tiles, const TeSampleRect& window, std::int64_t samples,
                                std::vector<TeSampleRect>& places);

  /// The bytes of the sample at a place; those of a row follow each other, rows lie rowBytes() apart.
  const unsigned char* place(std::int32_t column, std::int32_t row) const {
    return m_samples.data() + offset(column, row);
  }
  /// The bytes of a sample; null if it is not held.
  const unsigned char* sample(std::int32_t x, std::int32_t y) const {
    return m_held.holds(x, y) ? place(x % m_side, y % m_side) : nullptr;
  }

private:
  std::size_t offset(std::int32_t column, std::int32_t row) const {
    return std::size_t(row) * rowBytes() + std::size_t(column) * std::size_t(m_bytesPerSample);
  }
  TeStatus load(TePyramidTiles& tiles, const TeSampleRect& rect, std::vector<TeSampleRect>& places);

  int m_level;
  int m_side;
  int m_bytesPerSample;
  TeSampleRect m_held;
  bool m_hasFailed = false;
  std::vector<unsigned char> m_samples;
};
