#include "patchdb/TeBlendWeights.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

/// The largest whole for which the products of two weights and a float's 24 bits are exact in a double.
constexpr int kSmoothWhole = 1 << 14;

double smoothStep(double t) { return t * t * t * (10 - t * (15 - 6 * t)); }

} // namespace

TeBlendWeights::TeBlendWeights(int cells, TeBlendProfile profile)
    : m_whole(profile == TeBlendProfile::Linear ? cells : kSmoothWhole),
      m_rising(static_cast<std::size_t>(cells) + 1) {
  assert(cells >= 1 && cells <= kSmoothWhole);
  m_rising.back() = m_whole;
  for (int x = 1; x < cells; ++x) {
    if (profile == TeBlendProfile::Linear) {
      m_rising[std::size_t(x)] = x;
      continue;
    }
    // The second half mirrors the first, so that both sides of a map fall alike.
    const int near = std::min(x, cells - x);
    const double rounded = std::floor(kSmoothWhole * smoothStep(double(near) / cells) + 0.5);
    const double weight = std::max(rounded, 1.0);
    m_rising[std::size_t(x)] = x == near ? weight : m_whole - weight;
  }
}

std::int64_t TeBlendWeights::weight(int map, int x, int y) const {
  const std::int64_t east = std::int64_t(m_rising[std::size_t(x)]);
  const std::int64_t north = std::int64_t(m_rising[std::size_t(y)]);
  return (map % 2 == 0 ? m_whole - east : east) * (map / 2 == 0 ? m_whole - north : north);
}
