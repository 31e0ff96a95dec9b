#include "engine/camera/TeCameraRig.h"

#include "engine/TeStateHash.h"
#include "engine/objects/TeObject.h"
#include "patchdb/TePatchDatabase.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using Key = SoKeyboardEvent::Key;

struct MoveKeys {
  std::array<Key, 2> keys; ///< numpad and elsewhere
  glm::dvec3 direction;    ///< in the object's frame
};

constexpr int kMoves = 6;
const std::array<MoveKeys, kMoves>& moveKeys() {
  static const std::array<MoveKeys, kMoves> moves = {{
      {{Key::PAD_8, Key::I}, {0, 1, 0}},
      {{Key::PAD_2, Key::K}, {0, -1, 0}},
      {{Key::PAD_4, Key::J}, {-1, 0, 0}},
      {{Key::PAD_6, Key::L}, {1, 0, 0}},
      {{Key::PAGE_UP, Key::U}, {0, 0, 1}},
      {{Key::PAGE_DOWN, Key::O}, {0, 0, -1}},
  }};
  return moves;
}

bool isMoveKey(Key key) {
  return std::any_of(moveKeys().begin(), moveKeys().end(),
                     [&](const MoveKeys& move) { return move.keys[0] == key || move.keys[1] == key; });
}

constexpr double kTilt = 0.12;        ///< of the third person's look, down for each metre ahead
constexpr double kLevelEnough = 1e-3; ///< least level part of a forward direction that gives a heading
constexpr double kFarthest = 1e30;    ///< from the origin, metres, so that floats stay finite
constexpr double kHalfTurn = 0.70710678118654752; ///< cosine and sine of half of 90°

/// From the camera's frame (looking along -z, y up) into an object's (looking along y, z up).
const glm::dquat kCameraInObject(kHalfTurn, kHalfTurn, 0, 0);

/// From the camera's frame into the world's, without rolling. `forward` is not vertical.
glm::dquat lookAlong(const glm::dvec3& forward) {
  const glm::dvec3 back = -glm::normalize(forward);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), back));
  return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

} // namespace

bool TeCameraRig::handleEvent(const TeKeyEvent& event) {
  if (isMoveKey(event.key)) {
    m_keys.change(event);
    return true;
  }
  const bool changesPerson = event.key == Key::C || event.key == Key::F2;
  const bool resets = event.key == Key::PAD_5 || event.key == Key::HOME;
  if (event.down && changesPerson)
    m_person = m_person == Person::First ? Person::Third : Person::First;
  if (event.down && resets)
    reset();
  return changesPerson || resets;
}

void TeCameraRig::update(double dt) {
  if (!moving())
    return;
  glm::dvec3 direction(0);
  for (const MoveKeys& move : moveKeys())
    if (m_keys.isDown(move.keys[0]) || m_keys.isDown(move.keys[1]))
      direction += move.direction;
  glm::dvec3& moved = m_moved[std::size_t(m_person)];
  moved = glm::clamp(moved + direction * (kSpeed * dt), -kLargestMove, kLargestMove);
}

bool TeCameraRig::moving() const { return m_keys.any(); }

void TeCameraRig::reset() { m_moved[std::size_t(m_person)] = glm::dvec3(0); }

TeStatus TeCameraRig::setMoved(const glm::dvec3& moved) {
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(moved[i]) <= kLargestMove))
      return TeError{"TeCameraRig: the camera can be moved by at most 1000 m along each axis"};
  m_moved[std::size_t(m_person)] = moved;
  return {};
}

void TeCameraRig::follow(const TeObject& object, const TePatchDatabase& terrain) {
  const glm::dvec3 forward = object.orientation() * glm::dvec3(0, 1, 0);
  const double level = std::sqrt(forward.x * forward.x + forward.y * forward.y);
  if (level > kLevelEnough)
    m_heading = {forward.x / level, forward.y / level, 0};
  if (m_person == Person::First)
    followFirst(object);
  else
    followThird(object, terrain);
  if (!(glm::length(m_eye - object.position()) < kFarthest)) // an offset of the object's class is not finite
    m_eye = object.position();
  m_objectDistance = glm::length(m_eye - object.position());
  const std::optional<double> ground = terrain.heightAt({m_eye.x, m_eye.y});
  m_heightAboveGround = ground ? m_eye.z - *ground : std::numeric_limits<double>::quiet_NaN();
}

void TeCameraRig::followFirst(const TeObject& object) {
  m_eye = object.position() + object.orientation() * (object.firstPersonOffset() + moved());
  m_orientation = object.orientation() * kCameraInObject;
}

void TeCameraRig::followThird(const TeObject& object, const TePatchDatabase& terrain) {
  const glm::dvec3 offset = object.thirdPersonOffset() + moved();
  const glm::dvec3 right(m_heading.y, -m_heading.x, 0);
  m_eye = object.position() + right * offset.x + m_heading * offset.y + glm::dvec3(0, 0, offset.z);
  if (const std::optional<double> ground = terrain.heightAt({m_eye.x, m_eye.y}))
    m_eye.z = std::max(m_eye.z, *ground + kEyeMargin);
  m_orientation = lookAlong({m_heading.x, m_heading.y, -kTilt});
}

void TeCameraRig::apply(SoPerspectiveCamera& camera, const glm::dvec3& worldOrigin,
                        const TeClipRange& range) const {
  const glm::dvec3 relative = glm::clamp(m_eye - worldOrigin, -kFarthest, kFarthest);
  const SbVec3f position(float(relative.x), float(relative.y), float(relative.z));
  if (camera.position.getValue() != position)
    camera.position = position;
  const glm::dquat& q = m_orientation;
  const SbRotation rotation(float(q.x), float(q.y), float(q.z), float(q.w));
  if (camera.orientation.getValue() != rotation)
    camera.orientation = rotation;
  if (camera.nearDistance.getValue() != float(range.nearDistance))
    camera.nearDistance = float(range.nearDistance);
  if (camera.farDistance.getValue() != float(range.farDistance))
    camera.farDistance = float(range.farDistance);
}

std::vector<std::string> TeCameraRig::helpLines() const {
  return {"C, F2  first or third person", "Num8/2, I/K  camera forward, back",
          "Num4/6, J/L  camera left, right", "PgUp/Dn, U/O  camera up, down",
          "Num5, Home  camera back to its place"};
}

std::uint64_t TeCameraRig::stateHash() const {
  std::uint64_t hash = teHashCombine(std::uint64_t(m_person), std::uint64_t(m_keys.down().size()));
  hash = teHashState(hash, m_keys);
  hash = teHashState(teHashState(teHashState(hash, m_moved[0]), m_moved[1]), m_eye);
  return teHashState(hash, m_orientation);
}
