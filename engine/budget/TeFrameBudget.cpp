#include "engine/budget/TeFrameBudget.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace {

constexpr double kRise = 0.05; ///< of the way to go, a frame
constexpr double kFall = 0.5;
constexpr double kForget = 0.95;    ///< of the longest unit that is kept a tick
constexpr double kWaitedOut = 0.05; ///< frames that differ less from the wanted time may have been waited out

/// Toward a value of a cost: fast if it grows.
void follow(double& estimate, double value) {
  estimate += (value > estimate ? kFall : kRise) * (value - estimate);
}

double median(std::array<double, 3> values) {
  std::sort(values.begin(), values.end());
  return values[1];
}

} // namespace

TeStatus TeFrameBudget::setBudget(double seconds) {
  if (!(seconds > 0 && seconds <= kMost))
    return TeError{"budget: " + std::to_string(seconds) + " s is not more than 0 and at most " +
                   std::to_string(kMost)};
  m_fixed = seconds;
  return {};
}

TeStatus TeFrameBudget::setFrameRate(double framesPerSecond) {
  if (framesPerSecond != 0 && !(framesPerSecond >= kLowestRate && framesPerSecond <= kHighestRate))
    return TeError{"frame rate: " + std::to_string(framesPerSecond) + " is neither 0 nor within " +
                   std::to_string(kLowestRate) + " to " + std::to_string(kHighestRate)};
  m_rate = framesPerSecond;
  m_draw = m_rest = 0;
  m_frames = 0;
  if (m_rate > 0)
    m_adapted = std::clamp(m_fixed, kLeast, frame() / 2);
  return {};
}

double TeFrameBudget::allowance() const { return std::max(budget() - m_reserve, budget() / 8); }

void TeFrameBudget::tickDone(double tickSeconds, double longestUnit) {
  if (tickSeconds >= 0 && std::isfinite(tickSeconds))
    m_tick = tickSeconds;
  if (std::isfinite(longestUnit))
    m_reserve = std::max(longestUnit, kForget * m_reserve);
}

void TeFrameBudget::frameDrawn(double frameSeconds, double drawSeconds) {
  if (m_rate == 0 || !(frameSeconds >= 0 && drawSeconds >= 0) || !std::isfinite(frameSeconds + drawSeconds))
    return;
  follow(m_draw, std::min(drawSeconds, frame()));
  m_lastRests[m_frames++ % m_lastRests.size()] =
      std::clamp(frameSeconds - drawSeconds - m_tick, 0.0, frame());
  if (m_frames < m_lastRests.size())
    return;
  const double rest = median(m_lastRests);
  const bool waitedOut = std::fabs(frameSeconds - frame()) < kWaitedOut * frame();
  if (rest < m_rest || !waitedOut)
    follow(m_rest, rest);
  else
    m_rest -= kCreep * m_rest;
  const double target = std::clamp((1 - kMargin) * frame() - m_draw - m_rest, kLeast, frame() / 2);
  m_adapted += (target > m_adapted ? kRise : 1) * (target - m_adapted);
}
