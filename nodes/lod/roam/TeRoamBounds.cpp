#include "nodes/lod/roam/TeRoamBounds.h"

#include "nodes/lod/roam/TeRoamErrorRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

float roundedUp(double value) {
  const float rounded = float(value);
  return double(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

float middleError(const float (&corners)[3], const float (&middles)[3]) {
  double worst = 0;
  for (int k = 0; k < 3; k++) {
    const double edge = (double(corners[k]) + double(corners[(k + 1) % 3])) / 2;
    worst = std::max(worst, std::fabs(double(middles[k]) - edge));
  }
  return roundedUp(worst);
}

} // namespace

std::shared_ptr<const TeRoamBounds> TeRoamBounds::create(TeLodFieldPtr field, bool withVariance) {
  std::shared_ptr<TeRoamBounds> bounds(new TeRoamBounds(std::move(field), withVariance));
  const int levels = bounds->field().cellsLog() - 1;
  bounds->m_bounds.resize(TeRoamTriangle::firstNumber(levels));
  if (withVariance)
    bounds->m_variances.resize(bounds->m_bounds.size());
  for (int level = levels - 1; level >= 0; level--) {
    bounds->measureLevel(level);
    bounds->inherit(level);
  }
  return bounds;
}

void TeRoamBounds::measureLevel(int level) {
  TeRoamErrorRows rows(field().heights(), field().cells() >> level);
  const int squares = rows.squares();
  std::vector<float> lower(std::size_t(squares), 0.0f), upper(std::size_t(squares), 0.0f);
  for (int y = 0; y < squares; y++) {
    rows.measure(y, lower.data(), upper.data());
    for (int x = 0; x < squares; x++)
      for (const bool isUpper : {false, true}) {
        const TeRoamTriangle triangle{level, x, y, isUpper};
        const std::uint32_t number = triangle.number();
        m_bounds[number].error = (isUpper ? upper : lower)[std::size_t(x)];
        if (m_hasVariance)
          m_variances[number] = middleError(triangle);
        if (level < field().cellsLog() - 2)
          continue;
        // The children are small ones.
        TeRoamBound& bound = m_bounds[number];
        bound.low = std::numeric_limits<float>::infinity();
        bound.high = -bound.low;
        for (int k = 0; k < 4; k++) {
          const TeRoamBound small = smallBound(triangle.child(k));
          bound.error = std::max(bound.error, small.error);
          bound.low = std::min(bound.low, small.low);
          bound.high = std::max(bound.high, small.high);
          if (m_hasVariance)
            m_variances[number] = std::max(m_variances[number], small.error);
        }
      }
  }
}

void TeRoamBounds::inherit(int level) {
  if (level >= field().cellsLog() - 2)
    return;
  for (std::uint32_t number = TeRoamTriangle::firstNumber(level);
       number < TeRoamTriangle::firstNumber(level + 1); number++) {
    TeRoamBound& bound = m_bounds[number];
    const TeRoamBound* children = &m_bounds[TeRoamTriangle::childOf(number, 0)];
    bound.low = std::min({children[0].low, children[1].low, children[2].low, children[3].low});
    bound.high = std::max({children[0].high, children[1].high, children[2].high, children[3].high});
    for (int k = 0; k < 4; k++)
      bound.error = std::max(bound.error, children[k].error);
    if (m_hasVariance)
      for (int k = 0; k < 4; k++)
        m_variances[number] = std::max(m_variances[number], m_variances[TeRoamTriangle::childOf(number, k)]);
  }
}

float TeRoamBounds::middleError(const TeRoamTriangle& triangle) const {
  float corners[3], middles[3];
  for (int k = 0; k < 3; k++) {
    const TeRoamTriangle::Point corner = triangle.corner(k, field().cellsLog());
    const TeRoamTriangle::Point middle = triangle.middle(k, field().cellsLog());
    corners[k] = field().height(corner.column, corner.row);
    middles[k] = field().height(middle.column, middle.row);
  }
  return ::middleError(corners, middles);
}

TeRoamBound TeRoamBounds::smallBound(const TeRoamTriangle& triangle) const {
  const int cellsLog = field().cellsLog();
  float corners[3], middles[3];
  for (int k = 0; k < 3; k++) {
    const TeRoamTriangle::Point corner = triangle.corner(k, cellsLog);
    corners[k] = field().height(corner.column, corner.row);
  }
  TeRoamBound bound{0, std::min({corners[0], corners[1], corners[2]}),
                    std::max({corners[0], corners[1], corners[2]})};
  if (triangle.level == cellsLog)
    return bound;
  for (int k = 0; k < 3; k++) {
    const TeRoamTriangle::Point middle = triangle.middle(k, cellsLog);
    middles[k] = field().height(middle.column, middle.row);
  }
  bound.error = ::middleError(corners, middles);
  bound.low = std::min({bound.low, middles[0], middles[1], middles[2]});
  bound.high = std::max({bound.high, middles[0], middles[1], middles[2]});
  return bound;
}
