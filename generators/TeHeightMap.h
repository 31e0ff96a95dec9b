#pragma once

#include "generators/base/TeResult.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// A rectangle of samples: columns x .. x+width-1, rows y .. y+height-1.
struct TeMapRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// What one pass over a rectangle of a map tells. Missing samples are counted and otherwise left out.
struct TeMapStatistics {
  float minimum = 0; ///< metres; 0 if every sample is missing
  float maximum = 0;
  double mean = 0;
  std::int64_t present = 0;
  std::int64_t missing = 0;
};

/// A rectangular grid of heights in metres, W columns by H rows, each at least 1.
///
/// Sample (column x, row y) is at(x, y) = data()[y * width() + x]; row 0 is the south, column 0 the west.
/// A sample may be *missing*: it then holds one fixed quiet NaN (isMissing tells). Arithmetic on a missing
/// sample gives a missing sample; no operation turns one into a number except fillMissing(). A finite value
/// never becomes infinite silently: operations whose result is not finite store a missing sample.
///
/// Values are cheap to move; copies copy the samples. Const members are thread-safe.
/// The operations between maps work over exactly given rectangles: one that does not lie wholly inside its
/// map, or source and destination of different size, is an error and changes nothing. Source and
/// destination may be the same map and may overlap.
class TeHeightMap {
public:
  static constexpr std::int64_t kMaxSamples = std::int64_t(1) << 28; ///< 1 GiB

  TeHeightMap() = default; ///< empty, 0×0
  /// All samples zero. Error: a side that is not positive, an area over kMaxSamples, not enough memory.
  static TeResult<TeHeightMap> create(int width, int height);

  int width() const { return m_width; }
  int height() const { return m_height; }
  bool empty() const { return m_samples.empty(); }
  std::size_t bytes() const { return m_samples.size() * sizeof(float); }
  TeMapRect bounds() const { return {0, 0, m_width, m_height}; }

  float* data() { return m_samples.data(); }
  const float* data() const { return m_samples.data(); }
  float* row(int y) { return m_samples.data() + std::size_t(y) * m_width; }
  const float* row(int y) const { return m_samples.data() + std::size_t(y) * m_width; }
  float& at(int x, int y) { return row(y)[x]; }
  float at(int x, int y) const { return row(y)[x]; }

  static bool isMissing(float height) { return height != height; }
  /// The value that stands for a missing sample.
  static float missing();
  bool hasMissing() const;
  void fillMissing(float height);

  /// Copy and arithmetic: destination = source, destination += source, and so on, sample for sample.
  TeStatus copy(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus add(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus subtract(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus multiply(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus addScaled(const TeHeightMap& source, float factor, TeMapRect from, TeMapRect to);
  TeStatus minimum(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus maximum(const TeHeightMap& source, TeMapRect from, TeMapRect to);
  TeStatus fill(float height, TeMapRect to);
  TeStatus scale(float factor, TeMapRect to);

  /// Minimum, maximum and mean in one pass.
  TeMapStatistics statistics() const;
  TeResult<TeMapStatistics> statistics(TeMapRect rect) const;

  /// Raises all heights by metres.
  void shift(float metres);
  /// Shifts so that the minimum, or the mean, comes to the given height (up to float rounding).
  void shiftMinimumTo(float height);
  void shiftMeanTo(float height);

  /// Bit for bit equality, missing samples included.
  friend bool operator==(const TeHeightMap& a, const TeHeightMap& b);
  friend bool operator!=(const TeHeightMap& a, const TeHeightMap& b) { return !(a == b); }

private:
  int m_width = 0;
  int m_height = 0;
  std::vector<float> m_samples;
};
