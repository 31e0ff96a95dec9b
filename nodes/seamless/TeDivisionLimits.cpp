#include "nodes/seamless/TeDivisionLimits.h"

#include <algorithm>

namespace {

/// Patches from first to last of which each has itself, one more on both sides and one sample beyond within
/// the samples low .. high, with `size` samples a patch; beyond the terrain's rim none is needed.
void spanInside(std::int32_t low, std::int32_t high, std::int32_t size, std::int32_t count,
                std::int32_t& first, std::int32_t& last) {
  if (high < low) { // nothing is inside
    first = 0;
    last = -1;
    return;
  }
  first = low <= 0 ? 0 : (low + 1 + size - 1) / size + 1;
  last = high >= size * count ? count - 1 : (high - 1) / size - 2;
}

/// Likewise of the children of parents parentFirst .. parentLast.
void spanOfChildren(std::int32_t parentFirst, std::int32_t parentLast, std::int32_t parents,
                    std::int32_t branching, std::int32_t& first, std::int32_t& last) {
  first = parentFirst == 0 ? 0 : parentFirst * branching + 1;
  last = (parentLast + 1) * branching - (parentLast == parents - 1 ? 1 : 2);
}

} // namespace

TeDivisionLimits::TeDivisionLimits(const TeSeamlessLayout& layout, const TeClipResidency* residency)
    : m_layout(layout), m_residency(residency) {
  if (residency)
    for (int level = 0; level < layout.depth() - 1; level++)
      m_divisible.push_back(divisible(level));
}

TeDivisionLimits::Rect TeDivisionLimits::divisible(int level) const {
  const std::int32_t count = m_layout.patchesPerSide(level);
  Rect rect{0, 0, count - 1, count - 1};
  if (level > 0) {
    const Rect& parents = m_divisible.back();
    if (parents.x1 < parents.x0 || parents.y1 < parents.y0)
      return {};
    const std::int32_t parentCount = m_layout.patchesPerSide(level - 1);
    spanOfChildren(parents.x0, parents.x1, parentCount, m_layout.branching(), rect.x0, rect.x1);
    spanOfChildren(parents.y0, parents.y1, parentCount, m_layout.branching(), rect.y0, rect.y1);
  }
  // Sides come to the highest resolution by way of all lower ones.
  for (int index = 1; index < m_layout.levels(); index++) {
    const int heights = m_layout.resolutionLog() - m_layout.spacingLog(level, index);
    if (heights > m_residency->top())
      return {};
    if (heights <= m_residency->base)
      continue;
    const TeClipWindow& window = m_residency->windows[std::size_t(heights - m_residency->base)];
    Rect inside;
    const std::int32_t size = m_layout.resolutionOf(index);
    spanInside(window.x, window.x + window.side - 1, size, count, inside.x0, inside.x1);
    spanInside(window.y, window.y + window.side - 1, size, count, inside.y0, inside.y1);
    rect = {std::max(rect.x0, inside.x0), std::max(rect.y0, inside.y0), std::min(rect.x1, inside.x1),
            std::min(rect.y1, inside.y1)};
  }
  return rect;
}

bool TeDivisionLimits::exists(int level, std::int32_t x, std::int32_t y) const {
  const int log = m_layout.levels() - 1;
  return level == 0 || m_divisible[std::size_t(level) - 1].holds(x >> log, y >> log);
}

int TeDivisionLimits::topIndex(const TeSideKey& side) const {
  const int top = m_layout.topIndex(side.level);
  if (!m_residency)
    return top;
  const std::int32_t last = m_layout.patchesPerSide(side.level) - 1;
  // The patches on both sides of it, or the one at the rim.
  const std::int32_t x0 = std::max(0, side.x - !side.horizontal), x1 = std::min(last, side.x);
  const std::int32_t y0 = std::max(0, side.y - side.horizontal), y1 = std::min(last, side.y);
  if (!exists(side.level, x0, y0) || !exists(side.level, x1, y1))
    return 0;
  // A side may come to any lower resolution too.
  for (int index = 1; index <= top; index++) {
    const int spacingLog = m_layout.spacingLog(side.level, index);
    const int log = m_layout.cellsLog(side.level) - spacingLog;
    const std::int32_t end = m_layout.resolution() >> spacingLog;
    // And the samples next to them, for normals.
    if (!m_residency->holds(m_layout.resolutionLog() - spacingLog, std::max(0, (x0 << log) - 1),
                            std::max(0, (y0 << log) - 1), std::min(end, ((x1 + 1) << log) + 1),
                            std::min(end, ((y1 + 1) << log) + 1)))
      return index - 1;
  }
  return top;
}
