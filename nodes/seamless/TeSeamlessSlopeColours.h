#pragma once

#include <glm/vec3.hpp>

#include <array>

/// Colours of the ground by height and slope: from the lowest ground up pebbles, sand, grass, gravel and
/// snow. What is too steep for a layer shows gravel in its place.
struct TeSeamlessSlopeColours {
  struct Layer {
    glm::vec3 colour{0}; ///< red, green, blue, each 0 .. 1
    float line = 0;      ///< metres: half this layer, half the one below; not used of the lowest
    float slope = 1;     ///< metres a metre: half this layer, half gravel
  };
  enum Ground { Pebbles, Sand, Grass, Gravel, Snow };

  std::array<Layer, 5> layers{{{{0.42f, 0.40f, 0.38f}, 0, 2.0f},
                               {{0.76f, 0.68f, 0.48f}, 50, 0.6f},
                               {{0.29f, 0.45f, 0.17f}, 150, 0.8f},
                               {{0.46f, 0.41f, 0.36f}, 1500, 9.0f},
                               {{0.94f, 0.95f, 0.98f}, 2200, 1.1f}}};
  float blend = 60;        ///< metres over which a layer goes over into the next; more than 0
  float slopeBlend = 0.3f; ///< the same, metres a metre

  /// Lines that divide the heights of a terrain: 4, 10, 55 and 75 % of the way from the lowest to the
  /// highest. Any finite heights, also equal ones.
  static TeSeamlessSlopeColours forHeights(float lowest, float highest);

  /// What the shader makes of a height in metres and a slope. Continuous.
  glm::vec3 colour(float height, float slope) const;
};
