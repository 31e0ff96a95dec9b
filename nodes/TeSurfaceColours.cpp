#include "nodes/TeSurfaceColours.h"

#include <algorithm>
#include <cmath>

namespace {

/// 0 below middle - width / 2, 1 above middle + width / 2, smooth between.
float smoothStep(float middle, float width, float value) {
  const float t = std::clamp((value - middle) / width + 0.5f, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

glm::vec3 mix(const glm::vec3& a, const glm::vec3& b, float t) { return a * (1 - t) + b * t; }

} // namespace

TeSurfaceColours TeSurfaceColours::forHeights(float mean, float highest) {
  TeSurfaceColours colours;
  const float range = std::max(highest - mean, 1e-3f);
  colours.rockLine = mean + 0.15f * range;
  colours.snowLine = mean + 0.60f * range;
  colours.blend = 0.30f * range;
  return colours;
}

glm::vec3 TeSurfaceColours::colour(float height, const glm::vec3& normal) const {
  const float across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
  const float slope = across / std::max(normal.z, 1e-6f);
  const float steep = smoothStep(rockSlope, slopeBlend, slope);
  const float high = smoothStep(rockLine, blend, height);
  const float top = smoothStep(snowLine, blend, height);
  const glm::vec3 ground = mix(grass, rock, std::max(high, steep));
  return mix(ground, snow, top * (1 - steep));
}

std::uint32_t TeSurfaceColours::packed(float height, const glm::vec3& normal) const {
  // Written so that a NaN is 0.
  const auto part = [](float value) {
    return std::uint32_t(std::lround(255 * (value > 0 ? std::min(value, 1.0f) : 0.0f)));
  };
  const glm::vec3 rgb = colour(height, normal);
  return part(rgb.r) << 24 | part(rgb.g) << 16 | part(rgb.b) << 8 | 0xFF;
}
