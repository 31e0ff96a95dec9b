#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

/// What a LOD method must know of a camera, in the coordinates of its terrain: x east, y north, z up, metres.
struct TeLodView {
  glm::dvec3 eye{0}; ///< of an orthographic camera: any point of its image plane
  bool perspective = true;
  /// Perspective: the size in pixels of a metre at a distance of one metre, that is viewport height / 2 /
  /// tan(half the vertical field of view). Orthographic: pixels a metre, at any distance. More than 0.
  double focal = 1;
  /// Metres by which the true eye may be nearer to anything than `eye`, which a viewer may hold still while
  /// the camera trembles. The planes are always those of the true eye. Not negative.
  double slack = 0;
  /// The first planeCount of them bound what is seen: dot(xyz, point) + w >= 0 inside; xyz is of unit length.
  std::array<glm::dvec4, 6> planes{};
  int planeCount = 0; ///< 0: everything is seen

  /// Size on the screen of a vertical deviation in metres at a distance from the eye, in pixels: the unit of
  /// all screen errors. Infinite where the distance is 0 and the deviation is not.
  double pixels(double deviation, double distance) const;
  /// False only if nothing of the box is seen; it may be true for some boxes near an edge that are not.
  bool meets(const glm::dvec3& low, const glm::dvec3& high) const;
};
