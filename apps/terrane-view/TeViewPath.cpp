#include "apps/terrane-view/TeViewPath.h"

#include "engine/paths/TeNamedPaths.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

constexpr double kSecondsPerSide = 60;
constexpr double kCircle = 0.3;       ///< radius of the circle, in sides
constexpr double kZigzag = 0.075;     ///< that many sides are what is kTeCircleRadius on the built-in path
constexpr double kMargin = 0.1;       ///< of the side: where the others begin, from the south
constexpr double kLongestStep = 0.05; ///< seconds; a longer one is cut
constexpr double kTurn = 6.28318530717958648;

/// The built-in path around its start, stretched so that it crosses a terrain of this side.
TeResult<TePath> namedPath(const std::string& name, const glm::dvec3& middle, double side, double altitude) {
  const TeResult<TePath> unit = teNamedPath(name, glm::dvec3(0), true);
  if (!unit)
    return unit.error();
  const double stretch = (name == "circle" ? kCircle : kZigzag) * side / kTeCircleRadius;
  const glm::dvec3 start = middle + (name == "circle" ? glm::dvec3(kCircle * side, 0, 0)
                                                      : glm::dvec3(0, (kMargin - 0.5) * side, 0));
  std::vector<TePathPoint> points = unit->points();
  for (TePathPoint& point : points)
    point.place = {start.x + stretch * point.place.x, start.y + stretch * point.place.y, altitude};
  return TePath::create(std::move(points), unit->repeats());
}

} // namespace

const std::vector<std::string>& TeViewPath::names() {
  static const std::vector<std::string> names = {"circle", "line", "zigzag"};
  return names;
}

TeResult<TeViewPath> TeViewPath::create(const std::string& path, const glm::dvec3& middle, double side,
                                        double altitude, double speed, const TeViewGround* ground) {
  const std::vector<std::string>& names = TeViewPath::names();
  const bool named = std::find(names.begin(), names.end(), path) != names.end();
  std::error_code ignored;
  if (!named && !std::filesystem::exists(path, ignored))
    return TeError{"--path: " + teQuoted(path) + " is no file and no built-in path" +
                   teKnownNames(path, names)};
  TeResult<TePath> made = named ? namedPath(path, middle, side, altitude) : TePath::read(path);
  if (!made)
    return made.error();
  const double usual = std::clamp(side / kSecondsPerSide, 1e-6, TePath::kMaxSpeed);
  return TeViewPath(TePathTraveller(std::move(*made), speed > 0 ? speed : usual, speed > 0), ground);
}

TeViewPath::TeViewPath(TePathTraveller traveller, const TeViewGround* ground)
    : m_traveller(std::move(traveller)), m_ground(ground) {
  arrive();
}

double TeViewPath::ground() const {
  const glm::dvec3 place = m_traveller.place();
  return m_ground ? m_ground->heightAt({place.x, place.y}).value_or(0) : 0;
}

/// At the start and after a jump.
void TeViewPath::arrive() {
  const glm::dvec3 place = m_traveller.place();
  const glm::dvec3 way = m_traveller.direction();
  m_altitude = place.z + (m_traveller.aboveGround() ? ground() : 0);
  m_climb = 0;
  m_yaw = std::atan2(way.y, way.x);
  m_pose = TeViewPose::along({place.x, place.y, m_altitude}, m_yaw, kPitch);
}

void TeViewPath::update(double dt) {
  const std::int64_t jumps = m_traveller.jumps();
  m_traveller.advance(dt);
  if (m_traveller.jumps() != jumps)
    return arrive();
  const glm::dvec3 place = m_traveller.place();
  if (m_traveller.aboveGround()) {
    const double below = ground();
    for (double left = std::min(dt, 1.0); left > 0; left -= kLongestStep) {
      const double step = std::min(left, kLongestStep);
      const double offset = below + place.z - m_altitude;
      m_climb += (kStiffness * kStiffness * offset - 2 * kStiffness * m_climb) * step;
      m_altitude += m_climb * step;
    }
    m_altitude = std::max(m_altitude, below + 0.5 * place.z);
  } else {
    m_altitude = place.z;
  }
  const glm::dvec3 way = m_traveller.direction();
  const double turn = std::remainder(std::atan2(way.y, way.x) - m_yaw, kTurn);
  m_yaw += turn * std::min(1.0, kTurning * dt);
  m_pose = TeViewPose::along({place.x, place.y, m_altitude}, m_yaw, kPitch);
}
