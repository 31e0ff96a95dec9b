#include "engine/paths/TePathTraveller.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>

TePathTraveller::TePathTraveller(TePath path, double speed, bool always)
    : m_path(std::move(path)), m_speed(speed), m_always(always) {
  assert(speed > 0 && speed <= TePath::kMaxSpeed);
  for (std::size_t leg = 1; leg < m_path.points().size(); ++leg)
    m_roundSeconds += secondsOf(leg);
}

double TePathTraveller::speedOf(std::size_t leg) const {
  const double own = m_path.points()[leg - 1].speed;
  return m_always || own == 0 ? m_speed : own;
}

double TePathTraveller::secondsOf(std::size_t leg) const { return m_path.legLength(leg) / speedOf(leg); }

bool TePathTraveller::nextLeg() {
  if (m_leg + 1 == m_path.points().size()) {
    if (!m_path.repeats())
      return false;
    m_shift += m_path.roundShift();
    m_leg = 0;
  }
  ++m_leg;
  m_along = 0;
  m_jumps += m_path.points()[m_leg].jump;
  return true;
}

/// Whole rounds at once, so that a short path at high speed costs no more than a long one.
void TePathTraveller::skipRounds(double& seconds) {
  const double rounds = std::floor(seconds / m_roundSeconds);
  if (!m_path.repeats() || rounds < 1)
    return;
  seconds = std::max(0.0, seconds - rounds * m_roundSeconds);
  m_shift += rounds * m_path.roundShift();
  m_distance += rounds * m_path.length();
  std::int64_t jumps = 0;
  for (const TePathPoint& point : m_path.points())
    jumps += point.jump;
  m_jumps += std::int64_t(rounds) * jumps;
}

void TePathTraveller::advance(double seconds) {
  assert(seconds >= 0 && std::isfinite(seconds));
  skipRounds(seconds);
  while (!m_ended) {
    const double left = m_path.legLength(m_leg) - m_along;
    const double step = speedOf(m_leg) * seconds;
    // A jump's end is left at once, so that nobody rests on it for a tick.
    if (step < left) {
      m_along += step;
      m_distance += step;
      return;
    }
    m_distance += left;
    seconds -= left / speedOf(m_leg);
    seconds = std::max(seconds, 0.0);
    if (!nextLeg()) {
      m_along = m_path.legLength(m_leg);
      m_ended = true;
    }
  }
}

glm::dvec3 TePathTraveller::place() const {
  const TePathPoint& end = m_path.points()[m_leg];
  if (end.jump || m_ended)
    return m_shift + end.place;
  return m_shift + m_path.points()[m_leg - 1].place + m_along * direction();
}

glm::dvec3 TePathTraveller::direction() const {
  // A path can end with a jump: then the leg before it counts.
  std::size_t leg = m_leg;
  while (leg > 1 && m_path.points()[leg].jump)
    --leg;
  if (m_path.points()[leg].jump)
    return {0, 1, 0};
  return glm::normalize(m_path.points()[leg].place - m_path.points()[leg - 1].place);
}

double TePathTraveller::speed() const { return m_ended ? 0 : speedOf(m_leg); }
