#include "nodes/seamless/TeSideMetric.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// Rounding must not decide whether neighbours fit: patches are divided a little before e = 1, coarse ones
/// before fine ones, and resolutions rise a little less before their limits (docs/seamless-patches.md).
constexpr double kDivideEarly = 1e-11;
constexpr double kDivideEarlyALevel = 1e-13;
constexpr double kRefineEarly = 0.8e-11;
/// Patches with morphing sides start to prepare for division a little later than their parents divide.
constexpr double kPrepareLate = 1 + 1e-6;
/// Pixels a metre at a metre's distance of the camera that stands for one without perspective.
constexpr double kUsualFocal = 1000;

/// Size of an error of no more than 0 is 0, also at no distance.
double seenFrom(double distance, double error) { return error > 0 ? error / distance : 0; }

double outside(double value, double low, double high) { return std::max({low - value, value - high, 0.0}); }

} // namespace

TeSideMetric::TeSideMetric(const TeSeamlessLayout& layout, const TeSeamlessBounds* bounds,
                           const TeSeamlessPlacement& placement, const TeLodView& view,
                           const TeSeamlessAccuracy& accuracy, double coarsening)
    : m_layout(layout), m_bounds(bounds), m_byError(bounds && (accuracy.exact || accuracy.pixelError > 0)),
      m_geomorph(accuracy.geomorph), m_perspective(view.perspective),
      m_eye((view.eye - placement.corner) / placement.spacing), m_slack(view.slack / placement.spacing),
      m_heightScale(placement.heightScale / placement.spacing),
      m_precision(std::max(view.perspective ? 1.0 : 0.0, accuracy.precision / coarsening)),
      m_rounding(accuracy.rounding) {
  const TeHeightRange range = bounds ? bounds->range(0, 0, 0) : placement.range;
  const double rise = outside(m_eye.z, range.low * m_heightScale, range.high * m_heightScale);
  m_squaredRise = rise * rise;
  m_flatDistance = kUsualFocal / (view.focal * placement.spacing);
  m_pixels = m_heightScale * view.focal * (view.perspective ? 1 : placement.spacing);
  // An exact picture that is over its budget begins anew with a small error.
  constexpr double kSmallError = 1.0 / 64;
  double wanted = accuracy.exact ? 0 : accuracy.pixelError;
  if (coarsening > 1)
    wanted = std::max(wanted, kSmallError) * coarsening;
  m_errorScale = wanted > 0 ? m_pixels / wanted : std::numeric_limits<double>::infinity();
}

double TeSideMetric::threshold(int level) const {
  if (m_byError)
    return m_geomorph ? double(TeSeamlessBounds::kMorphRatio) : 1;
  return 1 - (kDivideEarly + kDivideEarlyALevel * (m_layout.depth() - level));
}

double TeSideMetric::squaredDistance(const TeSideKey& side) const {
  if (!m_perspective)
    return m_flatDistance * m_flatDistance;
  const double length = m_layout.cells(side.level);
  const double x = side.x * length, y = side.y * length;
  const double dx = outside(m_eye.x, x, side.horizontal ? x + length : x);
  const double dy = outside(m_eye.y, y, side.horizontal ? y : y + length);
  return dx * dx + dy * dy + m_squaredRise;
}

double TeSideMetric::distanceToBox(const TeSideKey& side, double across, double along,
                                   TeHeightRange range) const {
  if (!m_perspective)
    return 1;
  const double length = m_layout.cells(side.level);
  const double end = m_layout.resolution();
  const double x = side.x * length, y = side.y * length;
  const double moreX = side.horizontal ? along : across, moreY = side.horizontal ? across : along;
  const double dx =
      outside(m_eye.x, std::max(0.0, x - moreX), std::min(end, (side.horizontal ? x + length : x) + moreX));
  const double dy =
      outside(m_eye.y, std::max(0.0, y - moreY), std::min(end, (side.horizontal ? y : y + length) + moreY));
  const double dz = outside(m_eye.z, range.low * m_heightScale, range.high * m_heightScale);
  return std::max(0.0, std::sqrt(dx * dx + dy * dy + dz * dz) - m_slack);
}

TeSideMetric::SeenSide TeSideMetric::see(const TeSideKey& side) const {
  SeenSide seen;
  seen.length = m_layout.cells(side.level);
  seen.squaredDistance = squaredDistance(side);
  if (!m_bounds)
    return seen;
  seen.errors = m_bounds->errors(side);
  // Both tiles lie in that box. An undivided patch's own errors are then no larger than the one beyond.
  const bool isDeepest = side.level == m_layout.depth() - 1;
  const TeHeightRange range = isDeepest ? m_bounds->side(side).range : m_bounds->beyondRange(side);
  seen.tilesDistance = distanceToBox(side, 0.5 * seen.length, 0, range);
  return seen;
}

double TeSideMetric::division(int level, std::int32_t x, std::int32_t y) const {
  const auto sideOf = [&](int side) { return TeSeamlessLayout::sideOf(level, x, y, TeSide(side)); };
  if (m_byError) {
    if (level == m_layout.depth() - 1)
      return 0;
    double division = 0;
    for (int side = 0; side < 4; side++)
      division = std::max(division, divisionByError(sideOf(side)));
    return division;
  }
  double distance = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 4; side++)
    distance = std::min(distance, squaredDistance(sideOf(side)));
  return m_precision * m_layout.cells(level) / std::sqrt(distance);
}

double TeSideMetric::divisionByError(const TeSideKey& side) const {
  const float beyond = m_bounds->beyond(side);
  if (beyond == 0)
    return 0;
  return seenFrom(distanceToBox(side, m_bounds->beyondAcross(side.level), m_bounds->beyondAlong(side.level),
                                m_bounds->beyondRange(side)),
                  m_errorScale * double(beyond));
}

float TeSideMetric::detail(const SeenSide& side) const {
  const int top = m_layout.levels() - 1;
  if (!m_byError) {
    double e = m_precision * side.length / std::sqrt(side.squaredDistance) * (1 + kRefineEarly);
    if (m_geomorph)
      return float(std::clamp(top + std::log2(e), 0.0, double(top)));
    int index = top;
    for (e *= 2; index > 0 && e <= 1; e *= 2)
      index--;
    return float(index);
  }
  if (m_geomorph) {
    constexpr double kStart = TeSeamlessBounds::kMorphRatio;
    double detail = 0;
    for (int index = 0; index < top && side.errors[index] > 0; index++)
      detail += std::clamp((wantedErrors(side, index) - kStart) / (1 - kStart), 0.0, 1.0);
    return float(detail);
  }
  int index = 0;
  while (index < top && side.errors[index] > 0 && wantedErrors(side, index) > 1)
    index++;
  return float(index);
}

double TeSideMetric::wantedErrors(const SeenSide& side, int index) const {
  return seenFrom(side.tilesDistance, m_errorScale * double(side.errors[index]));
}

float TeSideMetric::detailBefore(double division, int level) const {
  const double end = threshold(level);
  const int top = m_layout.levels() - 1;
  if (division > end)
    return float(top);
  if (!m_geomorph)
    return 0;
  // What children may reach while their parent's neighbours are undivided.
  const double start =
      kPrepareLate * (m_byError ? end * double(TeSeamlessBounds::kMorphRatio)
                                : 1 / (m_layout.branching() - 1 / std::max(1.0, m_precision)));
  if (start >= end)
    return 0;
  return float(top * std::clamp((division - start) / (end - start), 0.0, 1.0));
}

double TeSideMetric::errorPixels(const SeenSide& side, int index) const {
  return seenFrom(side.tilesDistance, m_pixels * (double(side.errors[index]) + m_rounding));
}

double TeSideMetric::squaredPrecision(const SeenSide& side, int index) const {
  const double lengths = side.length * (1 << (m_layout.levels() - 1 - index));
  return side.squaredDistance / (lengths * lengths);
}
