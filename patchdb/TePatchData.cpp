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
  dropSeams();
  m_heights = std::move(heights);
  m_deviation = deviation;
  float* samples = m_heights.data();
  const std::size_t count = m_heights.bytes() / sizeof(float);
  float low = HUGE_VALF, high = -HUGE_VALF;
  m_missing = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool finite = std::fabs(samples[i]) < HUGE_VALF;
    m_missing += finite ? 0 : 1;
    low = finite && samples[i] < low ? samples[i] : low;
    high = finite && samples[i] > high ? samples[i] : high;
  }
  if (m_missing > 0)
    for (std::size_t i = 0; i < count; ++i)
      if (!(std::fabs(samples[i]) < HUGE_VALF))
        samples[i] = TeHeightMap::missing();
  const bool any = low <= high;
  m_minimum = any ? low : 0;
  m_maximum = any ? high : 0;
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
