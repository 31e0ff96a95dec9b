#include "engine/objects/TeAutoDriver.h"

#include "engine/objects/TeTurn.h"
#include "generators/base/TeHash.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kGentle = 0.2;   ///< steepness that is no reason to turn
constexpr double kUnknown = 0.5;  ///< steepness of ground that is not known
constexpr double kBend = 0.02;    ///< curvature between the courses looked at, 1/m
constexpr int kBends = 3;         ///< to each side
constexpr double kNearest = 8;    ///< it looks at least this far, metres
constexpr int kPoints = 6;        ///< heights a course
constexpr double kSlowest = 0.3;  ///< m/s; below it counts as stuck
constexpr double kPatience = 1.5; ///< seconds
constexpr double kBackSeconds = 2.5;

/// A smooth wave of period 1 between -1 and 1, made of parabolas.
double wave(double x) {
  const double t = 2 * (x - std::floor(x)) - 1;
  return 4 * t * (1 - std::fabs(t));
}

/// Of the course without obstacles, after some metres; 1/m.
double plannedCurvature(double driven) { return 0.014 * wave(driven / 210) + 0.010 * wave(driven / 83); }

} // namespace

double TeAutoDriver::steepness(const TePatchDatabase& terrain, const Situation& situation,
                               double curvature) const {
  const double step = std::max(kNearest, kSeconds * std::fabs(situation.speed)) / kPoints;
  glm::dvec2 place = situation.place;
  glm::dvec2 heading = situation.heading;
  std::optional<double> last = terrain.heightAt(place);
  double steepest = 0;
  for (int i = 0; i < kPoints; ++i) {
    heading = teTurned(heading, curvature * step);
    place += heading * step;
    const std::optional<double> height = terrain.heightAt(place);
    const double rise = height && last ? std::fabs(*height - *last) / step : kUnknown;
    steepest = std::max(steepest, rise);
    last = height;
  }
  return steepest;
}

TeCarControls TeAutoDriver::backOut(double dt) {
  m_backing -= dt;
  TeCarControls controls;
  controls.throttle = -0.6;
  controls.steering = m_steering > 0 ? -1 : 1;
  return controls;
}

TeCarControls TeAutoDriver::drive(const TePatchDatabase& terrain, const Situation& situation, double dt) {
  m_driven += std::fabs(situation.speed) * dt;
  if (m_backing > 0)
    return backOut(dt);
  m_stuck = situation.speed < kSlowest ? m_stuck + dt : 0;
  if (m_stuck > kPatience) {
    m_stuck = 0;
    m_backing = kBackSeconds;
    return backOut(dt);
  }

  const double planned = plannedCurvature(m_driven);
  double best = INFINITY, curvature = 0, steep = 0;
  for (int bend = -kBends; bend <= kBends; ++bend) {
    const double tried = std::clamp(planned + bend * kBend, -situation.limit, situation.limit);
    const double steepnessThere = steepness(terrain, situation, tried);
    const double cost = 10 * std::max(0.0, steepnessThere - kGentle) + 0.05 * bend * bend;
    if (cost < best) {
      best = cost;
      curvature = tried;
      steep = steepnessThere;
    }
  }
  const double inCurve = std::sqrt(kComfort / std::max(std::fabs(curvature), 1e-3));
  const double onSlope = kSpeed / (1 + 3 * std::max(0.0, steep - kGentle));
  const double wanted = std::min({kSpeed, inCurve, onSlope});
  TeCarControls controls;
  controls.throttle = std::clamp(0.5 * (wanted - situation.speed), -1.0, 1.0);
  // A curvature to the left is positive, steering to the right is.
  controls.steering = situation.limit > 0 ? -curvature / situation.limit : 0;
  m_steering = controls.steering;
  return controls;
}

std::uint64_t TeAutoDriver::hash() const {
  return teHashDouble(teHashDouble(teHashDouble(teHashDouble(1, m_driven), m_stuck), m_backing), m_steering);
}
