#include "apps/terrane-view/TeFlyCamera.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using Key = SoKeyboardEvent::Key;

/// What a pair of keys (or of pairs) does while held: one way, and back.
struct Pair {
  std::array<Key, 2> more;
  std::array<Key, 2> less;
};
const Pair kAhead = {{Key::UP_ARROW, Key::R}, {Key::DOWN_ARROW, Key::F}};
const Pair kLeft = {{Key::LEFT_ARROW, Key::A}, {Key::RIGHT_ARROW, Key::D}};
const Pair kRise = {{Key::E, Key::E}, {Key::Q, Key::Q}};
const Pair kLookUp = {{Key::PAGE_UP, Key::U}, {Key::PAGE_DOWN, Key::O}};
const Pair kSlide = {{Key::J, Key::J}, {Key::L, Key::L}}; ///< to the left

constexpr double kTurnRate = 0.7;  ///< radians a second
constexpr double kSteepest = 1.55; ///< pitch, radians
constexpr double kRelative = 0.8;  ///< of the height above ground a second
constexpr double kSlowest = 0.002; ///< of the scene's size a second
constexpr double kQuickest = 0.25;

bool has(const std::array<Key, 2>& keys, Key key) { return keys[0] == key || keys[1] == key; }

double asked(const Pair& pair, const TeKeyState& state) {
  const auto down = [&](const std::array<Key, 2>& keys) {
    return state.isDown(keys[0]) || state.isDown(keys[1]);
  };
  return double(down(pair.more)) - double(down(pair.less));
}

} // namespace

bool TeFlyCamera::handleKey(const TeKeyEvent& event) {
  for (const Pair* pair : {&kAhead, &kLeft, &kRise, &kLookUp, &kSlide})
    if (has(pair->more, event.key) || has(pair->less, event.key)) {
      m_keys.change(event);
      return true;
    }
  return false;
}

void TeFlyCamera::turn(double left, double up) {
  const double pitch = std::clamp(m_pose.pitch() + up, -kSteepest, kSteepest);
  m_pose = TeViewPose::along(m_pose.eye, m_pose.yaw() + left, pitch);
}

void TeFlyCamera::makeFaster(double factor) {
  m_factor = std::clamp(m_factor * factor, 1 / kFastest, kFastest);
}

double TeFlyCamera::speed() const {
  const std::optional<double> ground =
      m_ground ? m_ground->heightAt({m_pose.eye.x, m_pose.eye.y}) : std::nullopt;
  const double high = std::abs(m_pose.eye.z - ground.value_or(0));
  return m_factor * std::clamp(kRelative * high, kSlowest * m_size, kQuickest * m_size);
}

void TeFlyCamera::update(double dt) {
  if (!moving())
    return;
  const double left = asked(kLeft, m_keys), up = asked(kLookUp, m_keys);
  if (left != 0 || up != 0)
    turn(left * kTurnRate * dt, up * kTurnRate * dt);
  const glm::dvec3 ahead = m_pose.forward();
  const glm::dvec3 toLeft = glm::cross(m_pose.up(), ahead);
  const glm::dvec3 way =
      ahead * asked(kAhead, m_keys) + toLeft * asked(kSlide, m_keys) + glm::dvec3(0, 0, asked(kRise, m_keys));
  if (way == glm::dvec3(0))
    return;
  m_pose.eye += way * (speed() * dt);
  if (!m_ground)
    return;
  if (const std::optional<double> ground = m_ground->heightAt({m_pose.eye.x, m_pose.eye.y}))
    m_pose.eye.z = std::max(m_pose.eye.z, *ground + kClearance * m_size);
}

std::vector<std::string> TeFlyCamera::helpLines() {
  return {"Up/Down, R/F  fly ahead, back", "Left/Right, A/D  turn",
          "PgUp/Dn, U/O  look up, down",   "E, Q  rise, sink",
          "J, L  slide left, right",       "mouse drag, wheel  look around, speed"};
}
