#pragma once

#include "nodes/lod/TeLodView.h"

/// A perspective camera without roll, in the coordinates of the terrain, metres.
struct TePerspectiveView {
  glm::dvec3 eye{0};
  glm::dvec3 forward{0, 1, 0}; ///< of unit length; not straight up or down
  int width = 1024;            ///< of the viewport, pixels
  int height = 768;
  double fieldOfView = 1.0471975511965976; ///< vertical, radians, between 0 and pi
  double nearDistance = 1;
  double farDistance = 30000; ///< more than nearDistance

  /// To the right and upward on the screen, of unit length.
  glm::dvec3 right() const;
  glm::dvec3 up() const;
  /// What a LOD method must know of it: all six planes.
  TeLodView lodView() const;
};
