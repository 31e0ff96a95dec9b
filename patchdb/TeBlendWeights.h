#pragma once

#include <cstdint>
#include <vector>

/// How the influence of a source map falls from 1 at its centre to 0 on its rim.
enum class TeBlendProfile {
  Linear, ///< as document 002 has it; the slope of the land has a crease along the borders of patches
  Smooth, ///< 6t⁵ - 15t⁴ + 10t³ of the linear weight t: slope and curvature go on across borders
};

/// The weights with which the four source maps of a patch are blended: whole numbers, so that they sum to
/// exactly one and four equal heights come back bit for bit.
///
/// Along one axis the map on the far side (east or north) has the weight rising(x), 0 at x = 0 and whole() at
/// x = n, the near one whole() - rising(x); a map's weight is the product of its two. Weights are positive
/// but for x = 0 and x = n. Linear: whole() = n, rising(x) = x. Smooth: whole() = 2^14, which rounds a
/// weight by up to 2^-15, so a height by up to that part of the difference between the maps.
class TeBlendWeights {
public:
  TeBlendWeights(int cells, TeBlendProfile profile);

  int cells() const { return int(m_rising.size()) - 1; } ///< n
  int whole() const { return m_whole; }
  /// Whole numbers for x = 0 .. n, as doubles.
  const double* rising() const { return m_rising.data(); }
  /// Weight of a map (0 = south-west, 1 = south-east, 2 = north-west, 3 = north-east) at patch sample (x, y),
  /// out of whole()².
  std::int64_t weight(int map, int x, int y) const;

private:
  int m_whole;
  std::vector<double> m_rising;
};
