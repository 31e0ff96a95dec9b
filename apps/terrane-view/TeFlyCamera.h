#pragma once

#include "apps/terrane-view/TeViewGround.h"
#include "apps/terrane-view/TeViewPose.h"
#include "engine/input/TeKeyState.h"

#include <string>
#include <vector>

/// A camera that flies freely by keys and mouse, faster the higher it is.
class TeFlyCamera {
public:
  static constexpr double kClearance = 2e-4; ///< of the scene's size, above the ground
  static constexpr double kFastest = 64;     ///< of the user's factor on the speed; and its inverse

  /// `size`: of the scene, which is the measure of speeds. `ground` may be null, else it outlives the camera.
  TeFlyCamera(const TeViewPose& pose, double size, const TeViewGround* ground)
      : m_pose(pose), m_size(size), m_ground(ground) {}

  const TeViewPose& pose() const { return m_pose; }
  void setPose(const TeViewPose& pose) { m_pose = pose; }
  /// True if the key is one of its own.
  bool handleKey(const TeKeyEvent& event);
  void releaseKeys() { m_keys.clear(); }
  /// Turns by angles, radians, to the left and up, as the mouse says.
  void turn(double left, double up);
  void makeFaster(double factor);
  /// Moves as the held keys say; seconds.
  void update(double dt);
  bool moving() const { return m_keys.any(); }
  double speed() const; ///< units a second of a held key

  static std::vector<std::string> helpLines();

private:
  TeViewPose m_pose;
  double m_size;
  const TeViewGround* m_ground;
  double m_factor = 1;
  TeKeyState m_keys;
};
