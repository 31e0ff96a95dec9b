#pragma once

#include "nodes/clipmap/TeClipResidency.h"
#include "nodes/seamless/TeSeamlessLayout.h"

#include <cstdint>
#include <vector>

/// How far patches may be divided and sides refined with the heights that are resident: by rectangles of
/// patches, so that all decisions stay functions of a patch or side alone and neighbours agree.
///
/// A patch may be divided if the heights of its children, and those around it at the same spacing, are
/// resident, and all patches around it exist or may come to exist. A side has the highest resolution whose
/// heights are resident for both of its patches and one sample around them (for normals that are the same on
/// both); it is 0 where one of the two cannot exist.
class TeDivisionLimits {
public:
  /// `residency` null: no limits.
  TeDivisionLimits(const TeSeamlessLayout& layout, const TeClipResidency* residency);

  bool mayDivide(int level, std::int32_t x, std::int32_t y) const {
    return level < m_layout.depth() - 1 && (!m_residency || m_divisible[std::size_t(level)].holds(x, y));
  }
  /// Highest resolution index that a side may have.
  int topIndex(const TeSideKey& side) const;

private:
  struct Rect {
    std::int32_t x0 = 0, y0 = 0, x1 = -1, y1 = -1; ///< inclusive
    bool holds(std::int32_t x, std::int32_t y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
  };
  Rect divisible(int level) const;
  bool exists(int level, std::int32_t x, std::int32_t y) const;

  TeSeamlessLayout m_layout;
  const TeClipResidency* m_residency;
  std::vector<Rect> m_divisible; ///< by level
};
