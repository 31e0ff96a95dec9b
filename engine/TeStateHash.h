#pragma once

#include "engine/input/TeKeyState.h"
#include "generators/base/TeHash.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

/// What hashes of states are made of: equal states have equal hashes, so 0 and -0 have the same.
inline std::uint64_t teHashState(std::uint64_t hash, double value) { return teHashDouble(hash, value + 0.0); }

inline std::uint64_t teHashState(std::uint64_t hash, const glm::dvec3& v) {
  return teHashState(teHashState(teHashState(hash, v.x), v.y), v.z);
}

inline std::uint64_t teHashState(std::uint64_t hash, const glm::dquat& q) {
  return teHashState(teHashState(teHashState(teHashState(hash, q.w), q.x), q.y), q.z);
}

/// The keys that are held.
inline std::uint64_t teHashState(std::uint64_t hash, const TeKeyState& keys) {
  for (const SoKeyboardEvent::Key key : keys.down())
    hash = teHashCombine(hash, std::uint64_t(key));
  return hash;
}
