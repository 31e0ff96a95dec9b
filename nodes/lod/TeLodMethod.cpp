#include "nodes/lod/TeLodMethod.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kExactStep = 1.0 / 64; ///< pixels, where an exact selection has to be lowered
constexpr double kCoarsest = 1e12;

} // namespace

bool TeLodMethod::select(const TeLodView& view, const TeLodAccuracy& accuracy) {
  TeAllowance unlimited = TeAllowance::unlimited();
  return select(view, accuracy, unlimited);
}

bool TeLodMethod::select(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance) {
  TeLodAccuracy wanted = accuracy;
  wanted.pixelError = accuracy.pixelError > 0 ? accuracy.pixelError : 0; // NaN, too
  wanted.maxTriangles = std::max<std::int64_t>(1, accuracy.maxTriangles);
  const TeLodDial& dial = this->dial();
  const bool usesDial = accuracy.dial > 0 && !dial.name.empty();
  wanted.dial = usesDial ? std::clamp(accuracy.dial, dial.least, dial.most) : 0;

  for (double coarsening = 1;; coarsening *= 2) {
    TeLodAccuracy tried = wanted;
    if (coarsening > 1) {
      tried.pixelError = std::max(wanted.pixelError, kExactStep) * coarsening;
      if (usesDial)
        tried.dial = std::clamp(dial.finerIsLarger ? wanted.dial / coarsening : wanted.dial * coarsening,
                                dial.least, dial.most);
    }
    std::vector<TeLodPart> parts = std::move(m_selection.parts);
    parts.clear();
    m_selection = TeLodSelection();
    m_selection.parts = std::move(parts);
    choose(view, tried, allowance, m_selection);
    m_selection.coarsening *= coarsening;
    if (m_selection.triangles <= wanted.maxTriangles || !coarsens() || coarsening > kCoarsest)
      return m_selection.complete;
  }
}

void TeLodMethod::appendMesh(TeLodMesh& mesh) const {
  for (std::size_t part = 0; part < m_selection.parts.size(); part++)
    appendPart(part, mesh);
}
