#include "nodes/lod/quadtree/TeQuadtreeDetail.h"

#include "generators/base/TeHash.h"

TeFractalDetail::TeFractalDetail(std::uint64_t seed, double amplitude, double growth) : m_seed(seed) {
  for (double& size : m_amplitudes) {
    size = amplitude;
    amplitude *= growth;
  }
}

float TeFractalDetail::displacement(std::int32_t column, std::int32_t row, int sideLog) const {
  const std::uint64_t place = std::uint64_t(std::uint32_t(row)) << 32 | std::uint32_t(column);
  const double uniform = double(teHashCombine(m_seed, place) >> 11) * 0x1p-52 - 1; // [-1, 1)
  return float(m_amplitudes[std::size_t(sideLog)] * uniform);
}
