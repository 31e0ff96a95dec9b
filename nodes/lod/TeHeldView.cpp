#include "nodes/lod/TeHeldView.h"

#include <glm/geometric.hpp>

namespace {

bool isSame(const TeLodView& a, const TeLodView& b) {
  return a.eye == b.eye && a.perspective == b.perspective && a.focal == b.focal && a.slack == b.slack &&
         a.planeCount == b.planeCount && a.planes == b.planes;
}

} // namespace

TeLodView TeHeldView::held(const TeLodView& view, double radius) const {
  TeLodView held = view;
  if (!view.perspective || !(radius > 0))
    return held;
  held.slack = view.slack + radius;
  if (m_isTaken && m_view.perspective && m_view.slack == held.slack &&
      glm::length(view.eye - m_view.eye) <= radius)
    held.eye = m_view.eye;
  return held;
}

bool TeHeldView::update(const TeLodView& view, double radius) {
  const TeLodView held = this->held(view, radius);
  const bool isNew = !m_isTaken || !isSame(m_view, held);
  m_view = held;
  m_isTaken = true;
  return isNew;
}
