#pragma once

#include "engine/camera/TeClipRange.h"
#include "engine/input/TeKeyState.h"
#include "generators/base/TeResult.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class SoPerspectiveCamera;
class TeObject;
class TePatchDatabase;

/// The camera that follows an object, in its first or third person.
///
/// Keys: C or F2 changes the person; numpad 8 and 2 (or I and K) move the camera forward and back, 4 and 6 (J
/// and L) left and right, page up and down (U and O) up and down for as long as they are held, numpad 5 (or
/// Home) puts it back. What the user has moved is kept for each person.
///
/// In first person the camera turns and rolls with the object. In third person the offset lies in the
/// object's heading, level; the camera looks along the heading, a little down, never rolls, and stays
/// kEyeMargin above known ground.
class TeCameraRig {
public:
  enum class Person { First, Third };
  static constexpr double kSpeed = 10;         ///< metres a second of held keys
  static constexpr double kLargestMove = 1000; ///< metres from the default offset, along each axis
  static constexpr double kEyeMargin = 2;      ///< metres

  Person person() const { return m_person; }
  void setPerson(Person person) { m_person = person; }
  /// True if the key is one of the rig's.
  bool handleEvent(const TeKeyEvent& event);
  /// Moves the camera as its held keys say. Seconds, any finite number ≥ 0.
  void update(double dt);
  /// Whether update() would move it.
  bool moving() const;
  /// Puts the camera of the present person back to the object's own offset.
  void reset();
  /// Forgets held keys, as when a window loses them.
  void releaseKeys() { m_keys.clear(); }
  /// Of the present person, from the object's own offset, in its frame; metres. Error: not finite or beyond kLargestMove.
  TeStatus setMoved(const glm::dvec3& moved);
  const glm::dvec3& moved() const { return m_moved[std::size_t(m_person)]; }

  /// Finds the eye's place for the object as it is now.
  void follow(const TeObject& object, const TePatchDatabase& terrain);
  const glm::dvec3& eye() const { return m_eye; } ///< world coordinates
  /// Turns Inventor's camera frame (x right, y up, looking along -z) into the world's.
  const glm::dquat& orientation() const { return m_orientation; }
  /// From the eye to the object's place.
  double objectDistance() const { return m_objectDistance; }
  /// Of the eye; NaN where the ground is not known.
  double heightAboveGround() const { return m_heightAboveGround; }

  /// Writes place, orientation and planes into a camera whose coordinates are relative to a point of the
  /// world. Only fields that differ are written, so that nothing is redrawn without need.
  void apply(SoPerspectiveCamera& camera, const glm::dvec3& worldOrigin, const TeClipRange& range) const;

  std::vector<std::string> helpLines() const;
  /// Of all that decides what is seen, now and as long as no key changes.
  std::uint64_t stateHash() const;

private:
  void followFirst(const TeObject& object);
  void followThird(const TeObject& object, const TePatchDatabase& terrain);

  Person m_person = Person::Third;
  TeKeyState m_keys;
  std::array<glm::dvec3, 2> m_moved{glm::dvec3(0), glm::dvec3(0)}; ///< by person
  glm::dvec3 m_heading{0, 1, 0}; ///< level; kept while an object looks straight up
  glm::dvec3 m_eye{0};
  glm::dquat m_orientation{1, 0, 0, 0};
  double m_objectDistance = 0;
  double m_heightAboveGround = 0;
};
