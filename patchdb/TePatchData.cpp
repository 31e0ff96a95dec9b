#include "patchdb/TePatchData.h"

#include <cmath>

TePatchData::~TePatchData() {
  dropSeams();
  for (TeDirection direction : kTeDirections)
    if (TePatchData* other = neighbour(direction))
      other->m_neighbours[std::size_t(teOpposite(direction))] = nullptr;
}

void TePatchData::link(TePatchData& patch, TeDirection direction, TePatchData& other) {
  patch.m_neighbours[std::size_t(direction)] = &other;
  other.m_neighbours[std::size_t(teOpposite(direction))] = &patch;
}

void TePatchData::setHeights(TeHeightMap heights, float deviation) {
  float* samples = heights.data();
  const std::size_t count = heights.bytes() / sizeof(float);
  std::int64_t missing = 0;
  for (std::size_t i = 0; i < count; ++i)
    missing += std::fabs(samples[i]) < HUGE_VALF ? 0 : 1;
  if (missing > 0)
    for (std::size_t i = 0; i < count; ++i)
      if (!(std::fabs(samples[i]) < HUGE_VALF))
        samples[i] = TeHeightMap::missing();
  TeHeightBlocks blocks(heights, missing > 0);

  dropSeams();
  m_heights = std::move(heights);
  m_blocks = std::move(blocks);
  m_missing = missing;
  m_deviation = deviation;
  if (m_missing == 0 && m_blocks.levels() > 0) {
    const TeHeightBlocks::Range& whole = m_blocks.range(m_blocks.levels(), 0, 0);
    m_minimum = whole.low;
    m_maximum = whole.high;
  } else {
    const TeMapStatistics statistics = m_heights.statistics();
    m_minimum = statistics.minimum;
    m_maximum = statistics.maximum;
  }
}

void TePatchData::dropHeights() { setHeights(TeHeightMap()); }

void TePatchData::shareSeam(TeDirection direction, const TePatchMeshPtr& seam) {
  const glm::ivec2 step = teStep(direction);
  m_seams[std::size_t(direction)] = seam;
  // Seen from another patch of the seam, it lies in the direction that leads from there to the same place.
  for (TeDirection to : kTeDirections) {
    const glm::ivec2 at = teStep(to);
    const bool meets = (at.x == 0 || at.x == step.x) && (at.y == 0 || at.y == step.y);
    TePatchData* other = meets ? neighbour(to) : nullptr;
    if (!other)
      continue;
    // An axis along which the other lies beyond the seam is mirrored.
    const glm::ivec2 back{at.x != 0 ? -step.x : step.x, at.y != 0 ? -step.y : step.y};
    for (TeDirection from : kTeDirections)
      if (teStep(from) == back)
        other->m_seams[std::size_t(from)] = seam;
  }
}

void TePatchData::dropSeams() {
  for (TeDirection direction : kTeDirections)
    if (m_seams[std::size_t(direction)])
      shareSeam(direction, nullptr);
}
