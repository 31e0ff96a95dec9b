#pragma once

#include "engine/objects/TeCarGeometry.h"
#include "patchdb/TePatchDatabase.h"

#include <glm/gtc/quaternion.hpp>

/// How a car stands on the surface: a function of its place and heading alone.
///
/// The body's plane is the least-squares plane through the surface below the four wheels. The surface is not
/// a plane, so every wheel then moves along the body's up, by its own *travel*, until the lowest point of its
/// tyre lies on the surface:
///
///     contact = position + right·x + forward·y + up·travel      (x, y of TeCarGeometry::wheel())
///     contact.z = heightAt(contact.xy)
///
/// which the first hit of a ray along -up gives up to rounding. On ground steeper than
/// TeCarGeometry::kSteepest the body stays level, and the wheels reach straight up and down. The travel is
/// not limited here: strain() tells whether a car can stand like this.
struct TeCarStance {
  struct Wheel {
    bool onGround = false; ///< false: there is no known ground below it, and it hangs
    double travel = 0;     ///< metres, up is positive
  };

  glm::dvec3 position{0}; ///< of the body's origin, on its plane
  // Unit and orthogonal.
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 forward{0, 1, 0};
  glm::dvec3 up{0, 0, 1};
  double slope = 0; ///< of the plane below the wheels, rise over run
  std::array<Wheel, TeCarGeometry::kWheels> wheels;

  /// `heading`: unit vector, seen from above. A wheel without ground takes the mean of the others' heights;
  /// without any, the car stays level at `height`.
  static TeCarStance on(const TePatchDatabase& terrain, glm::dvec2 place, glm::dvec2 heading, double height);

  bool complete() const; ///< all wheels on the ground
  /// The largest of travel and steepness, each as a share of what the car can take; at most 1 is acceptable.
  double strain() const;
  glm::dquat orientation() const;
};
