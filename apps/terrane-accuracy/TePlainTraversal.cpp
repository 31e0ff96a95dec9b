#include "apps/terrane-accuracy/TePlainTraversal.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

void TePlainTraversal::run(const TeLodView& view, double precision) {
  m_visited = 0;
  m_patches.clear();
  visit(view, precision, {});
}

void TePlainTraversal::visit(const TeLodView& view, double precision, const Patch& patch) {
  m_visited++;
  const double side = double(m_layout.cells(patch.level)) * m_placement.spacing;
  const TeHeightRange range = m_bounds ? m_bounds->range(patch.level, patch.x, patch.y) : m_placement.range;
  const glm::dvec3 low = m_placement.corner + glm::dvec3(patch.x * side, patch.y * side,
                                                         double(range.low) * m_placement.heightScale);
  const glm::dvec3 high =
      low + glm::dvec3(side, side, (double(range.high) - double(range.low)) * m_placement.heightScale);
  if (!view.meets(low, high))
    return;
  const glm::dvec3 away = view.eye - glm::clamp(view.eye, low, high);
  if (patch.level == m_layout.depth() - 1 || precision * precision * side * side <= glm::dot(away, away)) {
    m_patches.push_back(patch);
    return;
  }
  const std::int32_t branching = m_layout.branching();
  for (std::int32_t y = 0; y < branching; y++)
    for (std::int32_t x = 0; x < branching; x++)
      visit(view, precision, {patch.level + 1, patch.x * branching + x, patch.y * branching + y});
}
