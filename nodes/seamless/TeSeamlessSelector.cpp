#include "nodes/seamless/TeSeamlessSelector.h"

#include "nodes/seamless/TeDivisionLimits.h"
#include "nodes/seamless/TePatchMemo.h"
#include "nodes/seamless/TeSideMetric.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace {

/// One walk down the tree with one accuracy.
class Walk {
public:
  Walk(const TeSeamlessLayout& layout, const TeSeamlessBounds* bounds, const TeSeamlessPlacement& placement,
       const TeLodView& view, const TeSeamlessAccuracy& accuracy, const TeDivisionLimits& limits,
       double coarsening, TePatchMemo& memo, TeSeamlessSelection& selection)
      : m_layout(layout), m_bounds(bounds), m_placement(placement), m_view(view), m_limits(limits),
        m_metric(layout, bounds, placement, view, accuracy, coarsening), m_maxPatches(accuracy.maxPatches),
        m_memo(memo), m_selection(selection) {}

  /// False: more patches than the budget.
  bool run() {
    m_memo.clear();
    m_selection.patches.clear();
    m_selection.traversed = m_selection.culled = m_selection.triangles = 0;
    m_selection.errorBound = m_bounds ? 0 : std::numeric_limits<double>::infinity();
    const bool inBudget = visit(0, 0, 0, (1u << m_view.planeCount) - 1);
    m_selection.precision = std::sqrt(m_squaredPrecision);
    return inBudget;
  }

private:
  /// `planes`: those that cut the parent.
  bool visit(int level, std::int32_t x, std::int32_t y, unsigned planes) {
    m_selection.traversed++;
    if (planes != 0 && isOutside(level, x, y, planes)) {
      m_selection.culled++;
      return true;
    }
    const double division = divisionOf(level, x, y);
    if (!(division > m_metric.threshold(level)) || !m_limits.mayDivide(level, x, y)) {
      add(level, x, y, division);
      return std::int64_t(m_selection.patches.size()) <= m_maxPatches;
    }
    const int branching = m_layout.branching();
    for (int row = 0; row < branching; row++)
      for (int column = 0; column < branching; column++)
        if (!visit(level + 1, x * branching + column, y * branching + row, planes))
          return false;
    return true;
  }

  double divisionOf(int level, std::int32_t x, std::int32_t y) {
    if (!m_metric.asksNeighbours())
      return m_metric.division(level, x, y);
    return m_memo.get(level, x, y, [&] { return m_metric.division(level, x, y); });
  }

  void add(int level, std::int32_t x, std::int32_t y, double division) {
    TeSeamlessPatch patch;
    patch.level = std::int16_t(level);
    patch.x = x;
    patch.y = y;
    const float before = preparing(level, x, y, division);
    for (int side = 0; side < 4; side++) {
      const TeSideKey key = TeSeamlessLayout::sideOf(level, x, y, TeSide(side));
      const TeSideMetric::SeenSide seen = m_metric.see(key);
      float detail = std::max(m_metric.detail(seen), before);
      if (m_metric.asksNeighbours() && detail < float(m_layout.levels() - 1))
        detail = std::max(detail, neighbourPreparing(level, x, y, side));
      detail = std::min(detail, float(m_limits.topIndex(key)));
      patch.detail[std::size_t(side)] = detail;
      if (m_bounds)
        m_selection.errorBound =
            std::max(m_selection.errorBound, m_metric.errorPixels(seen, int(std::floor(detail))));
      m_squaredPrecision =
          std::max(m_squaredPrecision, m_metric.squaredPrecision(seen, teDetailResolution(detail)));
    }
    m_selection.triangles += trianglesOf(patch);
    m_selection.patches.push_back(patch);
  }

  /// What a patch asks of its sides because it is, or is about to be, divided.
  float preparing(int level, std::int32_t x, std::int32_t y, double division) const {
    return m_limits.mayDivide(level, x, y) ? m_metric.detailBefore(division, level) : 0.0f;
  }

  float neighbourPreparing(int level, std::int32_t x, std::int32_t y, int side) {
    const std::int32_t neighbourX = x + (side == TeEast) - (side == TeWest);
    const std::int32_t neighbourY = y + (side == TeNorth) - (side == TeSouth);
    const std::int32_t count = m_layout.patchesPerSide(level);
    if (neighbourX < 0 || neighbourY < 0 || neighbourX >= count || neighbourY >= count ||
        !m_limits.mayDivide(level, neighbourX, neighbourY))
      return 0;
    return m_metric.detailBefore(divisionOf(level, neighbourX, neighbourY), level);
  }

  /// Leaves in `planes` those that cut the patch's box.
  bool isOutside(int level, std::int32_t x, std::int32_t y, unsigned& planes) const {
    const double size = m_layout.cells(level) * m_placement.spacing;
    const TeHeightRange range = m_bounds ? m_bounds->range(level, x, y) : m_placement.range;
    const glm::dvec3 low =
        m_placement.corner + glm::dvec3(x * size, y * size, range.low * m_placement.heightScale);
    const glm::dvec3 high =
        m_placement.corner + glm::dvec3((x + 1) * size, (y + 1) * size, range.high * m_placement.heightScale);
    for (int i = 0; i < m_view.planeCount; i++) {
      if (!(planes & (1u << i)))
        continue;
      const glm::dvec4& plane = m_view.planes[std::size_t(i)];
      double farthest = plane.w, nearest = plane.w;
      for (int axis = 0; axis < 3; axis++) {
        const double atLow = plane[axis] * low[axis], atHigh = plane[axis] * high[axis];
        farthest += std::max(atLow, atHigh);
        nearest += std::min(atLow, atHigh);
      }
      if (farthest < 0)
        return true;
      if (nearest >= 0)
        planes &= ~(1u << i);
    }
    return false;
  }

  std::int64_t trianglesOf(const TeSeamlessPatch& patch) const {
    std::int64_t triangles = 0;
    for (int side = 0; side < 4; side++) {
      const std::int64_t half = m_layout.resolutionOf(patch.resolution(side)) / 2;
      const std::int64_t next = m_layout.resolutionOf(patch.resolution((side + 1) % 4)) / 2;
      triangles += 2 * (half - 1) * (half - 1);                    // tile
      triangles += half - 1 + next - 1 + 2 * std::max(half, next); // strip
    }
    return triangles;
  }

  const TeSeamlessLayout& m_layout;
  const TeSeamlessBounds* m_bounds;
  const TeSeamlessPlacement& m_placement;
  const TeLodView& m_view;
  const TeDivisionLimits& m_limits;
  const TeSideMetric m_metric;
  const std::int64_t m_maxPatches;
  double m_squaredPrecision = 0;
  TePatchMemo& m_memo;
  TeSeamlessSelection& m_selection;
};

} // namespace

TeSeamlessSelector::TeSeamlessSelector(const TeSeamlessLayout& layout,
                                       std::shared_ptr<const TeSeamlessBounds> bounds)
    : m_layout(layout), m_bounds(std::move(bounds)) {
  assert(!m_bounds || m_bounds->layout() == layout);
}

void TeSeamlessSelector::select(const TeLodView& view, const TeSeamlessPlacement& placement,
                                const TeSeamlessAccuracy& accuracy, const TeClipResidency* residency,
                                TeSeamlessSelection& selection) const {
  assert(accuracy.maxPatches >= 1 && placement.spacing > 0 && placement.heightScale >= 0);
  assert(m_bounds || (!accuracy.exact && !(accuracy.pixelError > 0)));
  thread_local TePatchMemo memo; // as large as the largest selection of the thread
  const TeDivisionLimits limits(m_layout, residency);
  // At some coarsening one patch is enough; but with perspective the document's precision ends at 1.
  constexpr double kMaxCoarsening = 1e30;
  for (double coarsening = 1;; coarsening *= 2) {
    selection.coarsening = coarsening;
    const bool mayBeCoarser =
        coarsening < kMaxCoarsening &&
        (accuracy.exact || accuracy.pixelError > 0 || !view.perspective || coarsening < accuracy.precision);
    TeSeamlessAccuracy tried = accuracy;
    if (!mayBeCoarser)
      tried.maxPatches = std::numeric_limits<int>::max();
    if (Walk(m_layout, m_bounds.get(), placement, view, tried, limits, coarsening, memo, selection).run())
      return;
  }
}
