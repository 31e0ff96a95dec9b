#include "engine/objects/TeAircraft.h"

#include "engine/TeStateHash.h"
#include "engine/objects/TeAircraftModel.h"
#include "engine/objects/TeTurn.h"
#include "generators/base/TeText.h"
#include "patchdb/TePatchDatabase.h"

#include <Inventor/nodes/SoSeparator.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {

using Key = SoKeyboardEvent::Key;

constexpr double kGravity = 9.81;
constexpr double kSteepestBank = 1.2 * kGravity; ///< lateral acceleration that still adds to the bank: 50°
constexpr double kBankRate = 15;                 ///< of the lateral acceleration, m/s² a second
constexpr double kLevelEnough = 1e-6;            ///< least level part of a direction that gives a heading
constexpr double kDegrees = 57.295779513082320877;

struct SteeringKeys {
  std::array<Key, 2> more;
  std::array<Key, 2> less;
};
const SteeringKeys kThrottle = {{Key::UP_ARROW, Key::R}, {Key::DOWN_ARROW, Key::F}};
const SteeringKeys kTurn = {{Key::RIGHT_ARROW, Key::D}, {Key::LEFT_ARROW, Key::A}};
const SteeringKeys kClimb = {{Key::E, Key::E}, {Key::Q, Key::Q}};

bool has(const std::array<Key, 2>& keys, Key key) { return keys[0] == key || keys[1] == key; }

bool has(const SteeringKeys& keys, Key key) { return has(keys.more, key) || has(keys.less, key); }

double asked(const SteeringKeys& keys, const TeKeyState& state) {
  const bool more = state.isDown(keys.more[0]) || state.isDown(keys.more[1]);
  const bool less = state.isDown(keys.less[0]) || state.isDown(keys.less[1]);
  return double(more) - double(less);
}

double levelLength(const glm::dvec3& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

} // namespace

TeAircraft::TeAircraft(std::string name, const SbColor& colour)
    : TeObject(std::move(name)), m_colour(colour) {}

void TeAircraft::setPilot(Pilot pilot) {
  m_pilot = std::move(pilot);
  wake();
}

TeStatus TeAircraft::setHeading(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  if (!std::isfinite(length) || !(length > 0))
    return TeError{name() + ": the heading must be a finite direction"};
  const double present = speed();
  m_forward = {x / length, y / length, 0};
  move(m_forward * present);
  bank(m_forward, 0);
  wake();
  return {};
}

double TeAircraft::speed() const { return glm::length(velocity()); }

glm::dvec3 TeAircraft::forward() const {
  const double present = speed();
  return present > 0 ? velocity() / present : m_forward;
}

void TeAircraft::update(const TeUpdate& update) {
  const glm::dvec3 before = m_forward;
  m_forward = forward();
  steer(m_pilot ? m_pilot(*this, update) : keySteering(), update.dt);
  keepClear(update.terrain);
  bank(before, update.dt);
}

TeAircraft::Steering TeAircraft::keySteering() const {
  if (!m_keys.any())
    return {};
  return {asked(kThrottle, m_keys), asked(kTurn, m_keys), asked(kClimb, m_keys)};
}

void TeAircraft::steer(const Steering& steering, double dt) {
  const glm::dvec3 start = velocity();
  const bool steered = steering.throttle != 0 || steering.turn != 0 || steering.climb != 0;
  m_levelling = steering.climb != 0 || (m_levelling && !m_pilot);
  if (steered || m_levelling) {
    const double present = speed();
    const double faster = present + std::clamp(steering.throttle, -1.0, 1.0) * kAcceleration * dt;
    const double level = levelLength(m_forward);
    if (level > kLevelEnough) {
      double slope = m_forward.z / level;
      const double limit = std::max(kSteepest, std::abs(slope));
      const double change = kClimbRate * dt;
      if (steering.climb != 0)
        slope = std::clamp(slope + std::clamp(steering.climb, -1.0, 1.0) * change, -limit, limit);
      else if (m_levelling)
        slope -= std::clamp(slope, -change, change);
      m_levelling = m_levelling && (slope != 0 || steering.climb != 0);
      const glm::dvec2 ahead(m_forward.x / level, m_forward.y / level);
      const double right = std::clamp(steering.turn, -1.0, 1.0) * kTurnRate * dt;
      m_forward = glm::normalize(glm::dvec3(teTurned(ahead, -right), slope));
    }
    move(m_forward * std::clamp(faster, 0.0, std::max(kFastest, present)));
  }
  place(position() + 0.5 * (start + velocity()) * dt);
}

void TeAircraft::keepClear(const TePatchDatabase& terrain) {
  const std::optional<double> ground = terrain.heightAt({position().x, position().y});
  if (!ground || position().z >= *ground + kClearance)
    return;
  place({position().x, position().y, *ground + kClearance});
  const double level = levelLength(m_forward);
  if (m_forward.z < 0 && level > kLevelEnough) {
    const double present = speed();
    m_forward = {m_forward.x / level, m_forward.y / level, 0};
    move(m_forward * present);
  }
}

void TeAircraft::bank(const glm::dvec3& forwardBefore, double dt) {
  if (dt > 0) {
    const double turned = forwardBefore.y * m_forward.x - forwardBefore.x * m_forward.y; // sine, to the right
    const double wanted = std::clamp(turned / dt * speed(), -kSteepestBank, kSteepestBank);
    m_lateral += std::clamp(wanted - m_lateral, -kBankRate * dt, kBankRate * dt);
  }
  if (levelLength(m_forward) <= kLevelEnough)
    return; // straight up or down: the wings stay as they are
  const glm::dvec3 levelRight = glm::normalize(glm::cross(m_forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 levelUp = glm::cross(levelRight, m_forward);
  const glm::dvec3 up = glm::normalize(levelUp * kGravity + levelRight * m_lateral);
  turn(glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(m_forward, up), m_forward, up))));
}

bool TeAircraft::moving() const {
  return TeObject::moving() || m_keys.any() || m_pilot || m_lateral != 0 || m_levelling;
}

bool TeAircraft::handleEvent(const TeKeyEvent& event) {
  if (!has(kThrottle, event.key) && !has(kTurn, event.key) && !has(kClimb, event.key))
    return false;
  if (m_keys.change(event))
    wake();
  return true;
}

void TeAircraft::releaseKeys() { m_keys.clear(); }

void TeAircraft::stop() {
  move(glm::dvec3(0));
  m_forward = orientation() * glm::dvec3(0, 1, 0);
  m_lateral = 0;
  m_levelling = false;
}

SoNode* TeAircraft::drawModel() { return teAircraftModel(m_colour); }

TeCollisionShape TeAircraft::collisionShape() const {
  return {TeCollisionShape::Kind::Box, {0, -0.4, 0.71}, {4.8, 4.2, 1.09}};
}

std::vector<std::string> TeAircraft::hudLines() const {
  const glm::dvec3 ahead = forward();
  const double heading = std::atan2(ahead.x, ahead.y) * kDegrees;
  return {teFormat("speed     %.1f m/s  %.0f km/h", speed(), speed() * 3.6),
          teFormat("heading   %.1f°", heading < 0 ? heading + 360 : heading),
          teFormat("climb     %+.1f m/s", velocity().z)};
}

std::vector<std::string> TeAircraft::helpLines() const {
  return {"Up/Down, R/F  faster, slower", "Left/Right, A/D  turn", "E, Q  climb, dive"};
}

std::uint64_t TeAircraft::stateHash() const {
  const std::uint64_t motion = teHashState(teHashState(TeObject::stateHash(), m_forward), m_lateral);
  return teHashCombine(teHashState(motion, m_keys), std::uint64_t(m_levelling));
}
