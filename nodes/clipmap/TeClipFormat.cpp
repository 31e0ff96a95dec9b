#include "nodes/clipmap/TeClipFormat.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

constexpr int kFractionBits = 10;
constexpr int kBias = 15;

std::uint16_t nearestHalf(int sample) {
  if (sample == 0)
    return 0;
  const double value = sample / 65535.0;
  int exponent = 0;
  std::frexp(value, &exponent); // value = fraction · 2^exponent, fraction in [0.5, 1)
  const int power = exponent > -13 ? exponent - 1 : -14; // of the first bit; of subnormal numbers -14
  const double steps = std::ldexp(value, kFractionBits - power);
  // A fraction that is rounded up to the next power carries into the exponent by itself.
  const long bits = std::lrint(steps);
  const bool subnormal = bits < 1 << kFractionBits;
  return std::uint16_t(subnormal ? bits : bits + ((power + kBias - 1) << kFractionBits));
}

} // namespace

int teTexelBytes(TeClipFormat format) {
  return format == TeClipFormat::Short || format == TeClipFormat::Half ? 2 : 4;
}

float teTexelScale(TeClipFormat format) { return format == TeClipFormat::Half ? 65535.0f : 1.0f; }

float teDrawnHeight(std::uint16_t sample, TeClipFormat format) {
  assert(format != TeClipFormat::Colour);
  if (format != TeClipFormat::Half)
    return float(sample);
  return teFloatOfHalf(teHalfOfSample(sample)) * teTexelScale(format);
}

float teDrawnRounding(TeClipFormat format) { return format == TeClipFormat::Half ? 16.0f : 0.0f; }

std::uint16_t teHalfOfSample(std::uint16_t sample) {
  static const std::vector<std::uint16_t> table = [] {
    std::vector<std::uint16_t> halves(65536);
    for (std::size_t i = 0; i < halves.size(); i++)
      halves[i] = nearestHalf(int(i));
    return halves;
  }();
  return table[sample];
}

float teFloatOfHalf(std::uint16_t half) {
  const int exponent = (half >> kFractionBits) & 31;
  const int fraction = half & ((1 << kFractionBits) - 1);
  const float sign = half & 0x8000 ? -1.0f : 1.0f;
  if (exponent == 0)
    return sign * std::ldexp(float(fraction), 1 - kBias - kFractionBits);
  return sign * std::ldexp(float(fraction + (1 << kFractionBits)), exponent - kBias - kFractionBits);
}
