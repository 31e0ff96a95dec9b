#pragma once

#include "engine/input/TeKeyState.h"
#include "engine/objects/TeObject.h"

#include <Inventor/SbColor.h>

#include <functional>

/// The simple aircraft of document 002: it flies where its nose points, at the speed that it was given.
///
/// Kinematic, without forces. Keys that are held change the velocity by a rate a second, so that the frame
/// rate does not matter: up and down (or R and F) faster and slower, left and right (A and D) turn, E and Q
/// climb and dive; without the last two it returns to level flight. A velocity that is set from outside is
/// flown on. It banks in turns as its lateral acceleration asks for, and stays kClearance above known ground.
class TeAircraft : public TeObject {
public:
  /// What keys or a pilot ask for, each -1 .. 1.
  struct Steering {
    double throttle = 0; ///< 1 = faster
    double turn = 0;     ///< 1 = to the right
    double climb = 0;    ///< 1 = up
  };
  /// Asked in every update in place of the keys.
  using Pilot = std::function<Steering(const TeAircraft& aircraft, const TeUpdate& update)>;

  static constexpr double kAcceleration = 15; ///< m/s²
  static constexpr double kFastest = 300;     ///< m/s by keys; what is set may be more
  static constexpr double kTurnRate = 0.5;    ///< radians a second
  static constexpr double kClimbRate = 0.8;   ///< of the slope, a second
  static constexpr double kSteepest = 1;      ///< slope by keys: 45°
  static constexpr double kClearance = 3;     ///< metres

  /// Rests, looking north, until it gets a velocity.
  explicit TeAircraft(std::string name, const SbColor& colour = SbColor(0.85f, 0.2f, 0.1f));

  /// Flies by itself; null gives it back to the keys.
  void setPilot(Pilot pilot);
  /// Points it level along (x, y) without changing its speed. Error: not finite or 0.
  TeStatus setHeading(double x, double y);
  /// Unit; where it flies or, at rest, where its nose points.
  glm::dvec3 forward() const;
  double speed() const; ///< m/s

  void update(const TeUpdate& update) override;
  bool moving() const override;
  bool handleEvent(const TeKeyEvent& event) override;
  void releaseKeys() override;
  void stop() override;

  SoNode* drawModel() override;
  TeCollisionShape collisionShape() const override;
  glm::dvec3 firstPersonOffset() const override { return {0, 0.6, 1.05}; }
  glm::dvec3 thirdPersonOffset() const override { return {0, -18, 4.5}; }
  std::vector<std::string> hudLines() const override;
  std::vector<std::string> helpLines() const override;
  std::uint64_t stateHash() const override;

private:
  Steering keySteering() const;
  /// Changes speed and direction as asked, and moves by the mean of the velocities before and after.
  void steer(const Steering& steering, double dt);
  void keepClear(const TePatchDatabase& terrain);
  void bank(const glm::dvec3& forwardBefore, double dt);

  SbColor m_colour;
  TeKeyState m_keys;
  Pilot m_pilot;
  glm::dvec3 m_forward{0, 1, 0};
  double m_lateral = 0;     ///< acceleration to the right that the bank shows, m/s²
  bool m_levelling = false; ///< after climb or dive by key
};
