#include "engine/objects/TeCar.h"

#include "engine/TeStateHash.h"
#include "engine/objects/TeCarModel.h"
#include "engine/objects/TeDriveTrain.h"
#include "engine/objects/TeTurn.h"
#include "generators/base/TeText.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

using Geometry = TeCarGeometry;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegrees = 180 / kPi;
/// No step is longer than a metre, however fast a program wants it to be.
constexpr double kFastest = 100;

TeError notFinite(const std::string& name, const char* what) {
  return TeError{name + ": " + what + " must be finite"};
}

} // namespace

TeCar::TeCar(std::string name) : TeObject(std::move(name)) {}

TeCar::~TeCar() = default;

TeStatus TeCar::setThrottle(double throttle) {
  if (!std::isfinite(throttle))
    return notFinite(name(), "the throttle");
  setAuto(false);
  m_controls.throttle = std::clamp(throttle, -1.0, 1.0);
  return {};
}

TeStatus TeCar::setSteering(double steering) {
  if (!std::isfinite(steering))
    return notFinite(name(), "the steering");
  setAuto(false);
  m_controls.steering = std::clamp(steering, -1.0, 1.0);
  return {};
}

void TeCar::setHandBrake(bool pulled) {
  setAuto(false);
  m_controls.handBrake = pulled;
}

void TeCar::setAuto(bool automatic) {
  if (automatic != isAuto()) {
    m_controls.release();
    m_driver = automatic ? std::optional<TeAutoDriver>(TeAutoDriver()) : std::nullopt;
  }
  wake();
}

double TeCar::speed() const { return glm::dot(velocity(), orientation() * glm::dvec3(0, 1, 0)); }

glm::dvec3 TeCar::wheelContact(int wheel) const {
  return position() + orientation() * (Geometry::wheel(wheel) + glm::dvec3(0, 0, m_wheels[wheel].travel));
}

TeCarStance TeCar::stanceAt(const TePatchDatabase& terrain, glm::dvec2 place, glm::dvec2 heading) const {
  return TeCarStance::on(terrain, place, heading, position().z);
}

void TeCar::update(const TeUpdate& update) {
  double speed = std::clamp(this->speed(), -kFastest, kFastest);
  if (orientation() != m_turned) {
    const glm::dvec2 forward(orientation() * glm::dvec3(0, 1, 0));
    const double length = glm::length(forward);
    m_heading = length > 1e-9 ? forward / length : m_heading;
  }
  TeCarStance stance = stanceAt(update.terrain, position(), m_heading);
  const int steps = std::max(1, int(std::ceil(update.dt / kLongestStep - 1e-9)));
  for (int i = 0; i < steps; ++i)
    step(update.terrain, stance, speed, update.dt / steps);

  m_turned = stance.orientation();
  m_wheels = stance.wheels;
  m_waiting = groundMayCome(update.terrain, stance);
  place(stance.position);
  turn(m_turned);
  move(stance.forward * speed);
  turnWheels();
}

void TeCar::step(const TePatchDatabase& terrain, TeCarStance& stance, double& speed, double dt) {
  if (m_driver)
    m_controls = m_driver->drive(
        terrain, {stance.position, m_heading, speed, largestTangent(speed) / Geometry::kWheelbase}, dt);
  steer(speed, dt);
  speed = TeDriveTrain::nextSpeed(speed, m_controls, stance.forward.z, stance.up.z, dt);
  if (!stance.complete())
    speed = 0;
  if (speed != 0)
    roll(terrain, stance, speed, speed * dt);
  else if (m_controls.throttle == 0)
    m_blocked = false;
}

double TeCar::largestTangent(double speed) const {
  return std::min(Geometry::kSteering, kSideways * Geometry::kWheelbase / std::max(speed * speed, 1e-3));
}

void TeCar::steer(double speed, double dt) {
  const double wanted = -m_controls.steering * largestTangent(speed);
  const double most = kSteeringRate * dt;
  m_steering =
      std::fabs(wanted - m_steering) <= most ? wanted : m_steering + (wanted > m_steering ? most : -most);
}

void TeCar::roll(const TePatchDatabase& terrain, TeCarStance& stance, double& speed, double distance) {
  // Half the turn before and half after the way: an arc, as seen from above, to the third order.
  const double angle = m_steering / Geometry::kWheelbase * distance;
  const glm::dvec2 halfway = teTurned(m_heading, 0.5 * angle);
  const glm::dvec2 heading = teTurned(halfway, 0.5 * angle);
  const double level = glm::length(glm::dvec2(stance.forward));
  const double toAxle = 0.5 * Geometry::kWheelbase * level;
  const glm::dvec2 place =
      glm::dvec2(stance.position) - m_heading * toAxle + halfway * (distance * level) + heading * toAxle;

  const TeCarStance next = stanceAt(terrain, place, heading / glm::length(heading));
  m_blocked = !next.complete() || next.strain() > std::max(1.0, stance.strain());
  if (m_blocked) {
    speed = 0;
    return;
  }
  stance = next;
  m_heading = heading / glm::length(heading);
  m_driven += std::fabs(distance);
  m_rolled = std::fmod(m_rolled + distance, 2 * kPi * Geometry::kWheelRadius);
}

bool TeCar::groundMayCome(const TePatchDatabase& terrain, const TeCarStance& stance) const {
  for (int i = 0; i < Geometry::kWheels; ++i) {
    if (stance.wheels[i].onGround)
      continue;
    const glm::dvec3 wheel = Geometry::wheel(i);
    const glm::dvec2 place(stance.position + stance.right * wheel.x + stance.forward * wheel.y);
    const TeResult<TePatchKey> key = tePatchAt(terrain.lattice(), place);
    const TePatchData* patch = key ? terrain.find(*key) : nullptr;
    if (key && !(patch && patch->hasHeights()))
      return true;
  }
  return false;
}

bool TeCar::moving() const {
  return TeObject::moving() || m_driver || m_waiting || m_steering != 0 || !m_controls.neutral();
}

bool TeCar::handleEvent(const TeKeyEvent& event) {
  if (event.key == SoKeyboardEvent::T) {
    if (event.down)
      setAuto(!isAuto());
    return true;
  }
  TeCarControls controls = isAuto() ? TeCarControls() : m_controls;
  if (!controls.handleEvent(event))
    return false;
  // A key that was held when the automatic driver took over says nothing by its release.
  if (isAuto() && !event.down)
    return true;
  setAuto(false);
  m_controls = controls;
  wake();
  return true;
}

void TeCar::releaseKeys() {
  if (!m_controls.anyKey())
    return;
  m_controls.release();
  wake();
}

SoNode* TeCar::drawModel() {
  if (!m_model)
    m_model = std::make_unique<TeCarModel>();
  turnWheels();
  return m_model->root();
}

void TeCar::turnWheels() {
  if (!m_model)
    return;
  for (int i = 0; i < Geometry::kWheels; ++i) {
    const bool front = i == Geometry::FrontLeft || i == Geometry::FrontRight;
    // Each front wheel stands square to the line to the centre of the curve (Ackermann).
    const double steering =
        front ? m_steering / (1 + m_steering * Geometry::wheel(i).x / Geometry::kWheelbase) : 0;
    m_model->setWheel(i, m_wheels[i].travel, steering, m_rolled / Geometry::kWheelRadius);
  }
}

TeCollisionShape TeCar::collisionShape() const {
  TeCollisionShape shape;
  shape.kind = TeCollisionShape::Kind::Box;
  shape.centre = {0, 0, 0.85};
  shape.halfExtents = {0.95, 1.95, 0.75};
  return shape;
}

std::vector<std::string> TeCar::hudLines() const {
  const glm::dvec3 forward = orientation() * glm::dvec3(0, 1, 0);
  const double speed = this->speed();
  const bool reverse = speed < 0 || (speed == 0 && m_controls.throttle < 0);
  const double angle = std::atan(m_steering) * kDegrees;
  const char* note = m_waiting ? "waiting for ground" : m_blocked ? "blocked" : isAuto() ? "automatic" : "";
  return {teFormat("speed     %.0f km/h  gear %s%s", std::fabs(speed) * 3.6, reverse ? "R" : "F",
                   m_controls.handBrake ? "  hand brake" : ""),
          teFormat("steering  %.0f° %s", std::fabs(angle),
                   angle > 0.5    ? "left"
                   : angle < -0.5 ? "right"
                                  : ""),
          teFormat("slope     %+.0f°  %s", std::asin(std::clamp(forward.z, -1.0, 1.0)) * kDegrees, note)};
}

std::vector<std::string> TeCar::helpLines() const {
  std::vector<std::string> lines = TeCarControls::helpLines();
  lines.push_back("T          drive by itself");
  return lines;
}

std::uint64_t TeCar::stateHash() const {
  std::uint64_t hash = teHashCombine(TeObject::stateHash(), m_controls.hash());
  hash = teHashCombine(hash, m_driver ? m_driver->hash() : 0);
  for (const double part : {m_heading.x, m_heading.y, m_steering, m_driven, m_rolled})
    hash = teHashState(hash, part);
  for (const TeCarStance::Wheel& wheel : m_wheels)
    hash = teHashState(teHashCombine(hash, std::uint64_t(wheel.onGround)), wheel.travel);
  return teHashCombine(hash, std::uint64_t(m_blocked) + 2 * std::uint64_t(m_waiting));
}
