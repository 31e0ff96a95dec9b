#include "generators/circles/TeCircle.h"

namespace {

float inverseSquare(double radius) { return float(1.0 / (radius * radius)); }

inline float hill(float dx, float dy, float scale, float height) {
  const float square = (dx * dx + dy * dy) * scale;
  const float q = square < 1.0f ? square : 1.0f; // farther out g would overflow, and 0 times infinity is no 0
  const float t = 1.0f - q;
  const float g =
      1.0f + q * (-0.467396855f + q * (0.0945197507f + q * (-0.0110260951f + q * 0.000753640876f)));
  return (t * t) * (g * height);
}

} // namespace

float TeCircle::at(std::int64_t x, std::int64_t y) const {
  return hill(float(std::int32_t(x - column)) - eastward, float(std::int32_t(y - row)) - northward,
              inverseSquare(radius), height);
}

void TeCircle::addToRun(std::int64_t x, std::int64_t y, int count, float* heights) const {
  const TeCircle circle = *this; // the compiler cannot know that heights do not overlap it
  const std::int32_t first = std::int32_t(x - circle.column);
  const float dy = float(std::int32_t(y - circle.row)) - circle.northward;
  const float scale = inverseSquare(circle.radius);
  for (int i = 0; i < count; ++i)
    heights[i] += hill(float(first + i) - circle.eastward, dy, scale, circle.height);
}

void TeCircle::addToPoints(const std::int32_t* x, const std::int32_t* y, std::size_t count,
                           float* heights) const {
  const TeCircle circle = *this;
  const std::int32_t column = std::int32_t(circle.column);
  const std::int32_t row = std::int32_t(circle.row);
  const float scale = inverseSquare(circle.radius);
  for (std::size_t i = 0; i < count; ++i)
    heights[i] += hill(float(x[i] - column) - circle.eastward, float(y[i] - row) - circle.northward, scale,
                       circle.height);
}
