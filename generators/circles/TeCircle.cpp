#include "generators/circles/TeCircle.h"

#include <cstring>

namespace {

float inverseSquare(double radius) { return float(1.0 / (radius * radius)); }

/// The smaller of a number that is not negative and 1; in whole numbers, which become vectors without a
/// branch.
inline float atMostOne(float number) {
  constexpr std::int32_t kOne = 0x3F800000;
  std::int32_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  bits = bits < kOne ? bits : kOne;
  std::memcpy(&number, &bits, sizeof bits);
  return number;
}

inline float hill(float dx, float dy, float scale, float height) {
  const float q = atMostOne((dx * dx + dy * dy) * scale); // farther out g would overflow
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
