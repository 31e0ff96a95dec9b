#include "nodes/lod/drawing/TeLodViewer.h"

#include <Inventor/elements/SoGLCacheContextElement.h>

namespace {

bool isSame(const TeLodAccuracy& a, const TeLodAccuracy& b) {
  return a.pixelError == b.pixelError && a.dial == b.dial && a.geomorph == b.geomorph &&
         a.maxTriangles == b.maxTriangles;
}

} // namespace

double TeLodViewer::holdRadius(const TeLodAccuracy& accuracy) const {
  return accuracy.geomorph && m_method->morphs() ? 0 : m_method->field().spacing() / 2;
}

bool TeLodViewer::hasChosen(const TeLodView& view, const TeLodAccuracy& accuracy) const {
  TeHeldView held = m_view;
  return m_selections > 0 && isSame(accuracy, m_accuracy) && !held.update(view, holdRadius(accuracy));
}

bool TeLodViewer::choose(const TeLodView& view, const TeLodAccuracy& accuracy, double slice) {
  const bool isNewView = m_view.update(view, holdRadius(accuracy));
  if (m_selections > 0 && !isNewView && isSame(accuracy, m_accuracy) && m_method->selection().complete)
    return false;
  m_accuracy = accuracy;
  TeAllowance allowance = slice > 0 ? TeAllowance::seconds(slice) : TeAllowance::unlimited();
  const double start = teThreadCpuSeconds();
  m_method->select(m_view.view(), accuracy, allowance);
  m_seconds = teThreadCpuSeconds() - start;
  m_selections++;
  return true;
}

TeLodRenderer& TeLodViewer::renderer(std::uint32_t context) {
  if (!m_renderer)
    m_renderer = std::make_shared<TeLodRenderer>(context);
  return *m_renderer;
}

void TeLodViewer::release(bool isCurrent) {
  if (m_renderer && isCurrent)
    m_renderer->freeAll();
  else if (m_renderer)
    SoGLCacheContextElement::scheduleDeleteCallback(
        m_renderer->context(),
        [](void* closure, std::uint32_t) {
          const std::unique_ptr<std::shared_ptr<TeLodRenderer>> held(
              static_cast<std::shared_ptr<TeLodRenderer>*>(closure));
          (*held)->freeAll();
        },
        new std::shared_ptr<TeLodRenderer>(m_renderer));
  m_renderer.reset();
}
