#include "nodes/clipmap/TeClipResidency.h"

bool TeClipResidency::holds(int level, std::int32_t x0, std::int32_t y0, std::int32_t x1,
                            std::int32_t y1) const {
  if (level <= base)
    return !windows.empty() && windows.front().side > 0;
  if (level > top())
    return false;
  return windows[std::size_t(level - base)].holds(x0, y0, x1, y1);
}
