#include "engine/quality/TeQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace {

constexpr double kSure = 4;     ///< standard deviations that noise does not explain
constexpr double kFarthest = 3; ///< of a cost from the goal that counts
constexpr double kOutlier = 3;  ///< standard deviations from the median that count
constexpr double kLeastNoise = 0.05;
constexpr double kMostStep = 0.5; ///< from frame to frame that is taken for noise
constexpr double kNoiseRate = 0.1;
constexpr double kLeastElasticity = 0.1;
constexpr double kMostElasticity = 3;
constexpr double kLearn = 4;       ///< factor by which one move may change the elasticity
constexpr double kShorter = 0.8;   ///< a way down is taken shorter: the elasticity grows on it
constexpr double kLeastMove = 0.1; ///< that something is learned from
constexpr double kShortest = 0.03; ///< seconds that say something, but kEnough frames always do
constexpr int kEnough = 8;
constexpr int kSettled = 8; ///< frames after which a cost is known well enough to learn from it

} // namespace

TeQuality::TeQuality() : m_least(std::log(kFinest)), m_most(std::log(kCoarsest)) {}

TeStatus TeQuality::setGoal(double seconds) {
  if (seconds != 0 && !(seconds >= kLeastGoal && seconds <= kMostGoal))
    return TeError{"goal of a frame: " + std::to_string(seconds) + " s is neither 0 nor within " +
                   std::to_string(kLeastGoal) + " to " + std::to_string(kMostGoal)};
  if (seconds != m_goal)
    restart();
  m_goal = seconds;
  return {};
}

TeStatus TeQuality::setRange(double finest, double coarsest) {
  if (!(finest > 0 && finest <= coarsest && coarsest <= kMostPixels))
    return TeError{"range of pixel errors: " + std::to_string(finest) + " to " + std::to_string(coarsest) +
                   " is not more than 0, rising and at most " + std::to_string(kMostPixels)};
  m_least = std::log(finest);
  m_most = std::log(coarsest);
  m_error = std::clamp(m_error, m_least, m_most);
  restart();
  return {};
}

double TeQuality::finest() const { return std::exp(m_least); }

double TeQuality::coarsest() const { return std::exp(m_most); }

double TeQuality::pixelError() const { return std::exp(m_error); }

void TeQuality::restart() {
  m_target = m_error;
  m_frames = 0;
  m_blind = 0;
  m_direction = 0;
  m_failures = 0;
  m_learns = m_restKnown = false;
}

void TeQuality::frameDrawn(double seconds) {
  if (!governs() || !(seconds > 0) || !std::isfinite(seconds))
    return;
  const double cost = std::clamp(std::log(seconds / m_goal), -kFarthest, kFarthest);
  if (moving())
    slew(seconds, cost);
  else if (m_blind > 0)
    --m_blind;
  else
    measure(cost);
  m_lastCost = cost;
}

void TeQuality::slew(double seconds, double cost) {
  const bool isUp = m_target > m_error;
  // Two frames on the other side of the goal: the way was meant to be longer than it has to be.
  if (isUp ? cost <= 0 && m_lastCost <= 0 : cost >= 0 && m_lastCost >= 0)
    m_target = m_error;
  else if (isUp)
    m_error = std::min(m_target, m_error + std::log(2.0) * std::min(seconds / kDoubling, 1.0));
  else
    m_error = std::max(m_target, m_error - 0.5 * std::log(2.0) * std::min(m_goal / kDoubling, 1.0));
  if (!moving()) {
    m_frames = 0;
    m_blind = kLatency;
  }
}

void TeQuality::measure(double cost) {
  m_costs[std::size_t(m_frames++ % kWindow)] = cost;
  decide();
  // Later, so that a dearer frame cannot hide behind the noise that it makes.
  if (m_frames >= 2)
    followNoise(cost);
}

void TeQuality::followNoise(double cost) {
  // Of two independent normal values the mean distance is 1.128 standard deviations.
  const double step = std::min(std::fabs(cost - m_lastCost), kMostStep) / 1.128;
  m_noise = std::max(kLeastNoise, m_noise + kNoiseRate * (step - m_noise));
}

/// Of the last frames, without what a single odd one does to a mean.
double TeQuality::estimate(int frames) const {
  const auto cost = [this](int back) { return m_costs[std::size_t((m_frames - 1 - back) % kWindow)]; };
  if (frames == 2) {
    const double a = cost(0), b = cost(1);
    return a > 0 && b > 0 ? std::min(a, b) : a < 0 && b < 0 ? std::max(a, b) : 0;
  }
  std::array<double, kWindow> sorted;
  for (int i = 0; i < frames; ++i)
    sorted[std::size_t(i)] = cost(i);
  std::sort(sorted.begin(), sorted.begin() + frames);
  const double median = 0.5 * (sorted[std::size_t((frames - 1) / 2)] + sorted[std::size_t(frames / 2)]);
  double sum = 0;
  for (int i = 0; i < frames; ++i)
    sum += std::clamp(sorted[std::size_t(i)], median - kOutlier * m_noise, median + kOutlier * m_noise);
  return sum / frames;
}

double TeQuality::band(int frames) const {
  return std::max(kDeadBand, kSure * m_noise / std::sqrt(double(frames)));
}

/// A large change shows in few frames, a small one only in many.
void TeQuality::decide() {
  double highest = -std::numeric_limits<double>::infinity();
  double dear = 0;
  double cost = 0; ///< of the most frames
  bool isCheap = false;
  for (int frames = 2; frames <= std::min(m_frames, kWindow); frames *= 2) {
    if (frames < kEnough && frames * m_goal < kShortest)
      continue;
    cost = estimate(frames);
    highest = std::max(highest, cost);
    if (cost > band(frames))
      dear = std::max(dear, cost);
    isCheap = isCheap || cost < -band(frames);
  }
  if (dear > 0)
    return move(dear);
  if (m_failures > 0 && m_frames >= kSettled / 2 && m_frames <= kWindow) {
    m_restKnown = true;
    m_restCost = cost;
  }
  if (isCheap && highest < -kDeadBand && mayFall(highest))
    return move(highest);
  if (m_learns && m_frames == kSettled)
    learn(cost);
}

bool TeQuality::mayFall(double cost) const {
  return m_failures == 0 || (m_failures == 1 && cost < -kNews) || (m_restKnown && cost < m_restCost - kNews);
}

void TeQuality::move(double cost) {
  learn(cost);
  double target = m_error + cost / m_elasticity * (cost < 0 ? kShorter : 1.0);
  if (cost < 0 && m_failures > 0) {
    if (m_restKnown && cost < m_restCost - kNews)
      m_failures = 0;
    else
      target = std::max(target, 0.5 * (m_error + m_dearError));
  }
  target = std::clamp(target, m_least, m_most);
  if (target == m_error)
    return; // at an end of the range
  const int direction = target > m_error ? 1 : -1;
  if (direction > 0 && m_direction < 0) {
    ++m_failures;
    m_dearError = m_error;
  }
  m_restKnown = false;
  m_direction = direction;
  m_learns = true;
  m_errorBefore = m_error;
  m_costBefore = cost;
  m_target = target;
  // The frame that has shown it counts for the first step, too.
  slew(m_goal * std::exp(cost), cost);
}

void TeQuality::learn(double cost) {
  if (!m_learns)
    return;
  m_learns = false;
  const double moved = m_error - m_errorBefore;
  if (std::fabs(moved) < kLeastMove)
    return;
  const double seen = (m_costBefore - cost) / moved;
  m_elasticity = std::clamp(std::clamp(seen, m_elasticity / kLearn, m_elasticity * kLearn), kLeastElasticity,
                            kMostElasticity);
}
