#pragma once

#include "nodes/seamless/TeSeamlessSelector.h"

#include <cstdint>
#include <vector>

/// What a selection is compared with: the same tree walked with no more than any quadtree does. A patch whose
/// box is in view is divided while its side, times the precision, is longer than the distance to its box.
/// Nothing joins neighbours: what it chooses has cracks.
class TePlainTraversal {
public:
  struct Patch {
    std::int32_t level = 0;
    std::int32_t x = 0;
    std::int32_t y = 0;
  };

  /// `bounds` may be null: boxes are then as high as the whole terrain.
  TePlainTraversal(const TeSeamlessLayout& layout, const TeSeamlessBounds* bounds,
                   const TeSeamlessPlacement& placement)
      : m_layout(layout), m_bounds(bounds), m_placement(placement) {}

  void run(const TeLodView& view, double precision);

  std::int64_t visited() const { return m_visited; }
  const std::vector<Patch>& patches() const { return m_patches; }

private:
  void visit(const TeLodView& view, double precision, const Patch& patch);

  TeSeamlessLayout m_layout;
  const TeSeamlessBounds* m_bounds;
  TeSeamlessPlacement m_placement;
  std::int64_t m_visited = 0;
  std::vector<Patch> m_patches;
};
