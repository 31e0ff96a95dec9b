#include "nodes/seamless/TeSeamlessSlopeColours.h"

#include <glm/common.hpp>

#include <algorithm>

namespace {

float above(float line, float blend, float value) {
  return glm::smoothstep(line - 0.5f * blend, line + 0.5f * blend, value);
}

} // namespace

TeSeamlessSlopeColours TeSeamlessSlopeColours::forHeights(float lowest, float highest) {
  TeSeamlessSlopeColours colours;
  const float range = std::max(highest - lowest, 1e-3f);
  const float lines[] = {0, 0.04f, 0.10f, 0.55f, 0.75f};
  for (std::size_t i = 0; i < colours.layers.size(); i++)
    colours.layers[i].line = lowest + lines[i] * range;
  colours.blend = 0.04f * range;
  return colours;
}

glm::vec3 TeSeamlessSlopeColours::colour(float height, float slope) const {
  glm::vec3 result{0};
  for (std::size_t i = 0; i < layers.size(); i++) {
    const Layer& layer = layers[i];
    const glm::vec3 ground =
        glm::mix(layer.colour, layers[Gravel].colour, above(layer.slope, slopeBlend, slope));
    result = i == 0 ? ground : glm::mix(result, ground, above(layer.line, blend, height));
  }
  return result;
}
