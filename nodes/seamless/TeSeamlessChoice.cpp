#include "nodes/seamless/TeSeamlessChoice.h"

#include "generators/base/TeAllowance.h"

namespace {

bool isSame(const TeSeamlessPlacement& a, const TeSeamlessPlacement& b) {
  return a.corner == b.corner && a.spacing == b.spacing && a.heightScale == b.heightScale &&
         a.range.low == b.range.low && a.range.high == b.range.high;
}

bool isSame(const TeSeamlessAccuracy& a, const TeSeamlessAccuracy& b) {
  return a.precision == b.precision && a.pixelError == b.pixelError && a.exact == b.exact &&
         a.geomorph == b.geomorph && a.maxPatches == b.maxPatches && a.rounding == b.rounding;
}

bool isSame(const TeClipResidency& a, const TeClipResidency& b) {
  if (a.base != b.base || a.windows.size() != b.windows.size())
    return false;
  for (std::size_t i = 0; i < a.windows.size(); i++) {
    if (a.windows[i].x != b.windows[i].x || a.windows[i].y != b.windows[i].y ||
        a.windows[i].side != b.windows[i].side)
      return false;
  }
  return true;
}

} // namespace

bool TeSeamlessChoice::hasGround(const TeSeamlessTerrainPtr& terrain,
                                 const TeSeamlessPlacement& placement) const {
  return m_terrain == terrain && isSame(m_placement, placement);
}

TeLodView TeSeamlessChoice::held(const TeSeamlessTerrainPtr& terrain, const TeLodView& view,
                                 const TeSeamlessPlacement& placement,
                                 const TeSeamlessAccuracy& accuracy) const {
  const double radius = accuracy.geomorph ? 0 : holdRadius(placement);
  return hasGround(terrain, placement) ? m_view.held(view, radius) : TeHeldView().held(view, radius);
}

bool TeSeamlessChoice::update(const TeSeamlessTerrainPtr& terrain,
                              const std::shared_ptr<const TeSeamlessParts>& parts, const TeLodView& view,
                              const TeSeamlessPlacement& placement, const TeSeamlessAccuracy& accuracy,
                              const TeClipResidency* residency) {
  if (!hasGround(terrain, placement))
    m_view.release();
  const bool isNewView = m_view.update(view, accuracy.geomorph ? 0 : holdRadius(placement));
  if (!isNewView && m_parts == parts && isSame(m_accuracy, accuracy) &&
      m_isLimited == (residency != nullptr) && (!residency || isSame(m_residency, *residency)))
    return false;

  m_terrain = terrain;
  m_parts = parts;
  m_placement = placement;
  m_accuracy = accuracy;
  m_isLimited = residency != nullptr;
  if (residency)
    m_residency = *residency;
  const double start = teThreadCpuSeconds();
  terrain->selector.select(m_view.view(), placement, accuracy, residency, m_selection);
  m_lists.build(m_selection, terrain->layout, *parts);
  m_seconds = teThreadCpuSeconds() - start;
  m_selections++;
  return true;
}
