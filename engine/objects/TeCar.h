#pragma once

#include "engine/objects/TeAutoDriver.h"
#include "engine/objects/TeCarControls.h"
#include "engine/objects/TeCarGeometry.h"
#include "engine/objects/TeCarStance.h"
#include "engine/objects/TeObject.h"

#include <memory>
#include <optional>

class TeCarModel;

/// A car on the one surface of the terrain: a kinematic bicycle model.
///
/// Seen from above, the middle of the rear axle moves along the heading and the heading turns by curvature ·
/// distance, where curvature = tan(angle of the front wheels) / wheelbase; the tyres never slip sideways. The
/// front wheels turn at kSteeringRate, and no farther than a sideways acceleration of kSideways allows. Speed
/// is TeDriveTrain's; place and heading decide how the car stands (TeCarStance): every wheel on the drawn
/// surface, whatever the ground. Steps of at most kLongestStep, so that runs of different frame rates agree
/// closely.
///
/// A step is not made, and the car stops as at a wall, if after it a wheel would have no known ground below
/// it (a hole in the data, terrain that is not there yet), or the car would stand beyond its suspension's
/// travel or TeCarGeometry::kSteepest - unless it already did, having been placed so, and the step makes that
/// less. A car that was placed with a wheel over nothing stays there; it waits as long as the ground may
/// still come.
///
/// The setters of TeObject hold: of a position x and y, of an orientation the heading, of a velocity its part
/// along the heading. Left alone it rolls to exact rest and sleeps, unless it slides on ground steeper than
/// the tyres hold. Cost: 2 to 4 microseconds a step.
class TeCar : public TeObject {
public:
  static constexpr double kLongestStep = 1.0 / 120; ///< seconds
  static constexpr double kSteeringRate = 1.6;      ///< of the tangent, 1/s
  static constexpr double kSideways = 6;            ///< m/s²

  explicit TeCar(std::string name);
  ~TeCar() override;

  /// Error, and nothing changed: not finite. Beyond -1 .. 1 it is limited. Ends automatic driving.
  TeStatus setThrottle(double throttle);
  TeStatus setSteering(double steering); ///< -1 full left .. 1 full right
  void setHandBrake(bool pulled);
  /// Drives by itself (TeAutoDriver), until a driving key or a setter takes over; key T, too.
  void setAuto(bool automatic);
  bool isAuto() const { return m_driver.has_value(); }

  double speed() const; ///< m/s along the heading, negative in reverse
  /// Tangent of the front wheels' angle, positive to the left.
  double steeringTangent() const { return m_steering; }
  bool onGround(int wheel) const { return m_wheels[wheel].onGround; }
  double travel(int wheel) const { return m_wheels[wheel].travel; }
  /// Where the lowest point of a wheel's tyre is, as it is drawn: world coordinates.
  glm::dvec3 wheelContact(int wheel) const;
  /// It stands before something that it cannot drive onto.
  bool blocked() const { return m_blocked; }
  double distanceDriven() const { return m_driven; } ///< metres, forward and back

  void update(const TeUpdate& update) override;
  bool moving() const override;
  bool needsGround() const override { return true; }
  /// A wheel's, on a level road, and what its suspension and the next step add.
  double groundReach() const override { return 3; }
  bool handleEvent(const TeKeyEvent& event) override;
  void releaseKeys() override;
  SoNode* drawModel() override;
  bool drawnInFirstPerson() const override { return true; } ///< its bonnet
  TeCollisionShape collisionShape() const override;
  glm::dvec3 firstPersonOffset() const override { return {-0.35, 0.1, 1.5}; }
  glm::dvec3 thirdPersonOffset() const override { return {0, -9, 3.2}; }
  std::vector<std::string> hudLines() const override;
  std::vector<std::string> helpLines() const override;
  std::uint64_t stateHash() const override;

private:
  TeCarStance stanceAt(const TePatchDatabase& terrain, glm::dvec2 place, glm::dvec2 heading) const;
  void step(const TePatchDatabase& terrain, TeCarStance& stance, double& speed, double dt);
  void steer(double speed, double dt);
  double largestTangent(double speed) const;
  void roll(const TePatchDatabase& terrain, TeCarStance& stance, double& speed, double distance);
  bool groundMayCome(const TePatchDatabase& terrain, const TeCarStance& stance) const;
  void turnWheels();

  TeCarControls m_controls;
  std::optional<TeAutoDriver> m_driver;
  glm::dvec2 m_heading{0, 1};      ///< unit
  glm::dquat m_turned{0, 0, 0, 0}; ///< the orientation that m_heading belongs to
  double m_steering = 0;
  double m_driven = 0;
  double m_rolled = 0; ///< of the wheels, metres modulo their circumference
  std::array<TeCarStance::Wheel, TeCarGeometry::kWheels> m_wheels;
  bool m_blocked = false;
  bool m_waiting = false; ///< for ground that may still come
  std::unique_ptr<TeCarModel> m_model;
};
