#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

/// Colours of the ground by height and slope: grass below, rock above and on steep slopes, snow on top, but
/// not where it would slide off.
struct TeSurfaceColours {
  glm::vec3 grass{0.29f, 0.45f, 0.17f}; ///< red, green, blue, each 0 .. 1
  glm::vec3 rock{0.46f, 0.41f, 0.36f};
  glm::vec3 snow{0.94f, 0.95f, 0.98f};
  float rockLine = 2;  ///< metres: half grass, half rock; the lines suit the default generator
  float snowLine = 8;  ///< metres: half rock, half snow
  float blend = 4;     ///< metres over which one goes over into the other; more than 0
  float rockSlope = 1; ///< metres a metre: half of level ground's colour, half rock
  float slopeBlend = 0.6f;

  /// Lines 15 and 60 % of the way from the mean height to the highest, so that a few peaks above a plain
  /// have their rock and snow too. Any finite heights, also mean = highest.
  static TeSurfaceColours forHeights(float mean, float highest);

  /// Red, green, blue of a point; continuous. A pure function of height and unit normal, so that pieces that
  /// share a vertex give it the same colour.
  glm::vec3 colour(float height, const glm::vec3& normal) const;
  /// colour() limited to 0 .. 1, packed as Coin does: 0xRRGGBBAA, opaque.
  std::uint32_t packed(float height, const glm::vec3& normal) const;
};
