#pragma once

#include <glm/vec3.hpp>

/// A point of a path.
struct TePathPoint {
  glm::dvec3 place{0};      ///< metres; z is an altitude, or a height above ground
  double speed = 0;         ///< m/s from here on; 0 = the traveller's own
  bool aboveGround = false; ///< z is relative to the ground at each point of the leg that ends here
  bool jump = false;        ///< reached at once from the point before, from however far

  friend bool operator==(const TePathPoint& a, const TePathPoint& b) {
    return a.place == b.place && a.speed == b.speed && a.aboveGround == b.aboveGround && a.jump == b.jump;
  }
};
