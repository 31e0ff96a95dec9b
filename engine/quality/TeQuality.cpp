#include "engine/quality/TeQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace {

constexpr double kSure = 4;     ///< standard deviations that noise does not explain
constexpr double kFarthest = 3; ///< of a cost from the goal that counts
constexpr double kOutlier = 3;  ///< standard deviations from the median that count
constexpr double kFirstNoise = 0.1;
constexpr double kLeastNoise = 0.05;
constexpr double kMostStep = 0.5; ///< from frame to frame that is taken for noise
constexpr double kLikely = 3;     ///< standard deviations that one distance of means counts at most
constexpr double kNoiseRate = 0.1;
constexpr double kMeanDistance = 1.128; ///< of two independent normal values, in standard deviations
constexpr double kLeastElasticity = 0.1;
constexpr double kMostElasticity = 3;
constexpr double kLearn = 4;       ///< factor by which one move may change the elasticity
constexpr double kShorter = 0.8;   ///< a way down is taken shorter: the elasticity grows on it
constexpr double kLeastMove = 0.1; ///< that something is learned from
constexpr double kShortest = 0.13; ///< seconds that say something, but kEnough frames always do
constexpr int kEnough = 8;
constexpr int kMostFrames = 1 << 30; ///< that are counted; a multiple of kWindow
constexpr int kMostFailures = 12;    ///< that are counted
constexpr int kProven = 16;          ///< frames after which an error is not too dear
constexpr int kSettled = 8;          ///< frames after which a cost is known well enough to learn from it

double leastNoise(int scale) {
  return (scale == 0 ? 1.0 : 0.5) * kLeastNoise / std::sqrt(double(1 << scale));
}

} // namespace

TeQuality::TeQuality() : m_least(std::log(kFinest)), m_most(std::log(kCoarsest)) {
  for (int scale = 0; scale < kScales; ++scale)
    m_noise[std::size_t(scale)] = leastNoise(scale);
  m_noise[0] = kFirstNoise;
}

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
  if (m_frames == kMostFrames)
    m_frames = 2 * kWindow;
  decide();
  // Later, so that a dearer frame cannot hide behind the noise that it makes.
  if (m_frames >= 2)
    followNoise(cost);
}

double TeQuality::meanOf(int frames, int back) const {
  double sum = 0;
  for (int i = 0; i < frames; ++i)
    sum += m_costs[std::size_t((m_frames - 1 - back - i) % kWindow)];
  return sum / frames;
}

/// What other programs do to a frame's cost lasts for many frames, and then the mean of many differs as much
/// as that of a few: each length has a deviation of its own.
void TeQuality::followNoise(double cost) {
  const auto follow = [this](int scale, double distance, double most) {
    double& noise = m_noise[std::size_t(scale)];
    const double seen = std::min(distance, most) / kMeanDistance;
    noise = std::max(leastNoise(scale), noise + kNoiseRate * (seen - noise));
  };
  follow(0, std::fabs(cost - m_lastCost), kMostStep);
  for (int scale = 1; scale < kScales; ++scale) {
    const int frames = 1 << scale;
    // A change of the load is a single large distance: it counts as one that is just likely.
    if (m_frames % frames == 0 && m_frames >= 2 * frames)
      follow(scale, std::fabs(meanOf(frames, 0) - meanOf(frames, frames)),
             kLikely * m_noise[std::size_t(scale)]);
  }
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
    sum += std::clamp(sorted[std::size_t(i)], median - kOutlier * m_noise[0], median + kOutlier * m_noise[0]);
  return sum / frames;
}

/// What the mean of 2^scale frames has to be off the goal by.
double TeQuality::band(int scale) const {
  const double ofFrames = kSure * m_noise[0] / std::sqrt(double(1 << scale));
  // A mean of half as many differs by no less.
  const double ofMeans = scale >= 2 ? kSure * m_noise[std::size_t(scale - 1)] : 0;
  return std::max({kDeadBand, ofFrames, ofMeans});
}

/// A large change shows in few frames, a small one only in many.
void TeQuality::decide() {
  double highest = -std::numeric_limits<double>::infinity();
  double dear = 0;
  double cost = 0; ///< of the most frames
  bool isKnown = false, isCheap = false, isNews = false;
  for (int scale = 1; 1 << scale <= std::min(m_frames, kWindow); ++scale) {
    const int frames = 1 << scale;
    const double seen = estimate(frames);
    if (frames < kEnough && frames * m_goal * std::exp(std::max(seen, 0.0)) < kShortest)
      continue;
    cost = seen;
    isKnown = true;
    highest = std::max(highest, cost);
    if (cost > band(scale))
      dear = std::max(dear, cost);
    isCheap = isCheap || cost < -band(scale);
    isNews = isNews || (m_restKnown && cost < m_restCost - std::max(kNews, band(scale)));
  }
  if (dear > 0)
    return rise(dear);
  if (isKnown && m_failures > 0 && m_direction > 0 && m_frames <= kWindow) {
    m_restKnown = true;
    m_restCost = cost;
  }
  if (isNews || (m_frames >= kProven && m_error <= m_dearError))
    m_failures = 0; // it is not too dear any more
  if (isCheap && highest < -kDeadBand && mayFall(highest))
    return fall(highest);
  if (m_frames == kSettled)
    learn(cost);
}

bool TeQuality::mayFall(double cost) const {
  return m_failures == 0 ||
         (cost < -kNews &&
          (m_failures == 1 || m_frames * m_goal >= std::ldexp(kPatience, 2 * (m_failures - 2))));
}

void TeQuality::rise(double cost) {
  learn(cost);
  double target = m_error + cost / m_elasticity;
  const bool isFailure = m_direction < 0 && m_frames <= kWindow;
  if (m_frames > kWindow)
    m_failures = 0; // something else has made it dear, so that nothing is known any more
  if (isFailure && m_failures > 0)
    target = std::max(target, m_safeError);
  if (std::min(target, m_most) == m_error)
    return; // at the coarse end
  if (isFailure) {
    m_failures = std::min(m_failures + 1, kMostFailures);
    m_dearError = m_error;
  }
  m_restKnown = false;
  move(std::min(target, m_most), cost);
}

void TeQuality::fall(double cost) {
  learn(cost);
  double target = m_error + kShorter * cost / m_elasticity;
  if (m_failures > 0)
    target =
        std::max(target, m_failures == 1 && m_direction > 0 ? 0.5 * (m_error + m_dearError) : m_dearError);
  target = std::max(target, m_least);
  if (target >= m_error)
    return; // at the fine end, or at what was too dear
  m_safeError = m_error;
  move(target, cost);
}

void TeQuality::move(double target, double cost) {
  m_direction = target > m_error ? 1 : -1;
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
