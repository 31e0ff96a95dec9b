#pragma once

#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <array>
#include <cstdint>
#include <vector>

/// Deviations of triangles that many patches have alike, of eight patches at a time: which samples lie under
/// them, and by which weights their heights follow from those of the corners, is worked out once.
class TeGeoMipSampler {
public:
  static constexpr int kLanes = 8; ///< patches at a time

  explicit TeGeoMipSampler(int patchCells) : m_width(patchCells + 1) {}

  /// Height of sample (x, y) of each patch at (y·(P + 1) + x)·kLanes.
  using Block = std::vector<float>;
  using Lanes = std::array<float, kLanes>;

  struct Weighted {
    std::uint16_t sample; ///< y·(P + 1) + x
    std::array<std::uint16_t, 3> corners;
    std::array<float, 3> weights; ///< powers of two times whole numbers: exact
  };
  using Samples = std::vector<Weighted>;

  /// All samples that triangles cover, their rims included, but for the corners. Twice the area of a triangle
  /// in cells is a power of two.
  Samples samples(const std::vector<TeGeoMipPatterns::Triangle>& triangles) const;
  /// The largest deviation of each patch, rounded up.
  static Lanes deviations(const Samples& samples, const Block& block);

private:
  int m_width;
};
