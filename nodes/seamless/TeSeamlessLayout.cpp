#include "nodes/seamless/TeSeamlessLayout.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace {

bool isPowerOfTwo(int number) { return number > 0 && (number & (number - 1)) == 0; }

int log2Of(int powerOfTwo) {
  int log = 0;
  while ((1 << log) < powerOfTwo)
    log++;
  return log;
}

TeError outOfRange(const char* what, int value, const std::string& allowed) {
  return {std::string("seamless patches: ") + what + " " + std::to_string(value) + " is not " + allowed};
}

} // namespace

TeResult<TeSeamlessLayout> TeSeamlessLayout::create(int resolution, int minResolution, int levels) {
  if (levels < 2 || levels > kMaxLevels)
    return outOfRange("number of levels", levels, "between 2 and " + std::to_string(kMaxLevels));
  if (!isPowerOfTwo(minResolution) || minResolution < 2 ||
      minResolution > (kMaxPatchResolution >> (levels - 1)))
    return outOfRange("minimum patch resolution", minResolution,
                      "a power of two between 2 and " + std::to_string(kMaxPatchResolution >> (levels - 1)) +
                          " (with " + std::to_string(levels) + " levels)");
  if (!isPowerOfTwo(resolution) || resolution < minResolution || resolution > kMaxResolution)
    return outOfRange("resolution", resolution,
                      "a power of two between " + std::to_string(minResolution) + " and " +
                          std::to_string(kMaxResolution));
  TeSeamlessLayout layout;
  layout.m_resolution = resolution;
  layout.m_resolutionLog = log2Of(resolution);
  layout.m_minLog = log2Of(minResolution);
  layout.m_levels = levels;
  const int divisions = std::max(0, layout.m_resolutionLog - layout.m_minLog - (levels - 1));
  layout.m_depth = (divisions + levels - 2) / (levels - 1) + 1;
  return layout;
}

int TeSeamlessLayout::topIndex(int level) const { return std::min(m_levels - 1, cellsLog(level) - m_minLog); }

std::int64_t TeSeamlessLayout::firstPatch(int level) const {
  const std::int64_t children = std::int64_t(1) << (2 * (m_levels - 1));
  return ((std::int64_t(1) << (2 * level * (m_levels - 1))) - 1) / (children - 1);
}

std::int64_t TeSeamlessLayout::patchCount() const { return firstPatch(m_depth); }

std::int64_t TeSeamlessLayout::sideCount(int level) const {
  const std::int64_t n = patchesPerSide(level);
  return 2 * n * (n + 1);
}

std::int64_t TeSeamlessLayout::sideIndex(const TeSideKey& side) const {
  const std::int64_t n = patchesPerSide(side.level);
  assert(side.x >= 0 && side.y >= 0 && side.x < n + !side.horizontal && side.y < n + side.horizontal);
  return side.horizontal ? side.y * n + side.x : n * (n + 1) + side.y * (n + 1) + side.x;
}

TeSideKey TeSeamlessLayout::sideOf(int level, std::int32_t x, std::int32_t y, TeSide side) {
  switch (side) {
  case TeNorth:
    return {level, true, x, y + 1};
  case TeEast:
    return {level, false, x + 1, y};
  case TeSouth:
    return {level, true, x, y};
  case TeWest:
    break;
  }
  return {level, false, x, y};
}

bool operator==(const TeSeamlessLayout& a, const TeSeamlessLayout& b) {
  return a.m_resolution == b.m_resolution && a.m_minLog == b.m_minLog && a.m_levels == b.m_levels;
}
