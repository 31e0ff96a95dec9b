#pragma once

#include <array>
#include <cstdint>

/// Where a quadtree has no data: heights of vertices relative to the middle of the edge that they split.
/// A pure function, so that what was dropped is made again bit for bit. Thread-safe.
class TeQuadtreeDetail {
public:
  virtual ~TeQuadtreeDetail() = default;
  /// Of the vertex at (column, row) that is the centre, or the middle of an edge, of a square of side
  /// 2^sideLog; in the unit of the heights. Finite.
  virtual float displacement(std::int32_t column, std::int32_t row, int sideLog) const = 0;
};

/// Midpoint displacement, with random numbers that depend on the place and the seed only.
class TeFractalDetail final : public TeQuadtreeDetail {
public:
  /// Displacements are uniform in ±amplitude for squares of side 1, and in ±amplitude · growth^k for those of
  /// side 2^k.
  TeFractalDetail(std::uint64_t seed, double amplitude, double growth = 1.75);
  float displacement(std::int32_t column, std::int32_t row, int sideLog) const override;

private:
  std::uint64_t m_seed;
  std::array<double, 32> m_amplitudes{};
};
