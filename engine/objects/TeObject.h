#pragma once

#include "engine/input/TeKeyEvent.h"
#include "engine/objects/TeCollisionShape.h"
#include "engine/objects/TeUpdate.h"
#include "generators/base/TeResult.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

class SoNode;
class TeObjects;

/// Anything that is placed in the world: an aircraft, a car, a tower.
///
/// World coordinates, metres; x east, y north, z up. An object's own frame is x right, y forward, z up, so
/// that without rotation it looks north. An object at rest costs nothing a tick: the engine updates only
/// those that are awake, and lets an object sleep once moving() is false; every setter wakes it. For the
/// thread that makes all Coin calls.
class TeObject {
public:
  explicit TeObject(std::string name);
  virtual ~TeObject();
  TeObject(const TeObject&) = delete;
  TeObject& operator=(const TeObject&) = delete;

  const std::string& name() const { return m_name; }
  const glm::dvec3& position() const { return m_position; }
  const glm::dvec3& velocity() const { return m_velocity; }       ///< m/s
  const glm::dquat& orientation() const { return m_orientation; } ///< unit
  /// Error, and nothing changed: a number that is not finite. Any distance may be jumped.
  TeStatus setPosition(const glm::dvec3& position);
  TeStatus setVelocity(const glm::dvec3& velocity);
  /// Any rotation but 0; it is normalised.
  TeStatus setOrientation(const glm::dquat& orientation);

  /// One step of time. By default position += velocity * dt.
  virtual void update(const TeUpdate& update);
  /// Whether it has to be updated again; asked after each update. By default: the velocity is not 0.
  virtual bool moving() const;
  /// An object that stands on the ground: it is not updated before the patch below it is known.
  virtual bool needsGround() const { return false; }
  /// How far from its place the object stands on the ground, in x and y, metres: the patches below the four
  /// corners of that square are wanted as much as the one below it.
  virtual double groundReach() const { return 0; }
  /// A key, if this is the active object; true if it meant something to it.
  virtual bool handleEvent(const TeKeyEvent& event);
  /// Forgets keys that are held: it is no longer the active object, or the window has lost the keyboard.
  virtual void releaseKeys() {}

  /// Drawn at the object's place, in its own frame; null = nothing. Asked once, when the object is added.
  virtual SoNode* drawModel();
  /// Whether it is drawn, too, while the camera is in first person.
  virtual bool drawnInFirstPerson() const { return false; }
  /// The simpler model that collisions are found with.
  virtual TeCollisionShape collisionShape() const { return {}; }

  /// Where the camera is, in the object's frame, as long as its user has not moved it.
  virtual glm::dvec3 firstPersonOffset() const { return {0, 0, 0}; }
  virtual glm::dvec3 thirdPersonOffset() const { return {0, -12, 4}; }

  /// Lines for the HUD besides those that every object has (position, velocity, height above ground).
  virtual std::vector<std::string> hudLines() const { return {}; }
  /// What its keys do, for the HUD's help: a line each of keys, two spaces or more, and their meaning.
  virtual std::vector<std::string> helpLines() const { return {}; }

  /// Of position, velocity, orientation, and what a class adds: equal states have equal hashes.
  virtual std::uint64_t stateHash() const;

  /// Brings it to rest where it is; called after an update that left something that is not finite. By default
  /// the velocity becomes 0.
  virtual void stop();

  /// Makes the engine update this object, until it is no longer moving().
  void wake();
  bool awake() const { return m_awake; }

protected:
  // For update(): without checks.
  void place(const glm::dvec3& position) { m_position = position; }
  void turn(const glm::dquat& orientation) { m_orientation = orientation; }
  void move(const glm::dvec3& velocity) { m_velocity = velocity; }

private:
  friend class TeObjects;
  bool isFinite() const;

  std::string m_name;
  glm::dvec3 m_position{0};
  glm::dvec3 m_velocity{0};
  glm::dquat m_orientation{1, 0, 0, 0};
  bool m_awake = true;
  TeObjects* m_owner = nullptr;
  std::uint64_t m_order = 0; ///< among the owner's objects
};
