#include "generators/noise/TeNoiseReference.h"

namespace {

TeQuad magnitude(TeQuad x) { return x < 0 ? -x : x; }
TeQuad lerp(TeQuad t, TeQuad a, TeQuad b) { return a + t * (b - a); }
TeQuad fade(TeQuad t) { return 6 * t * t * t * t * t - 15 * t * t * t * t + 10 * t * t * t; }

/// The polynomial that stands for sin(π·t), -1 ≤ t < 1.
TeQuad sine(TeQuad t) {
  const TeQuad parabola = 4 * t * (1 - magnitude(t));
  return parabola + TeQuad(0.225) * (parabola * magnitude(parabola) - parabola);
}

std::uint64_t line(std::uint64_t cell, std::uint64_t seed) {
  std::uint64_t z = cell * 0x9E3779B97F4A7C15u + seed;
  z ^= z >> 32;
  z *= 0xD6E8FEB86659FD93u;
  return z ^ (z >> 32);
}

/// Whole cells per metre along and across the first axis, octave k.
struct Turn {
  TeQuad along, across;
};

Turn turn(const TeNoiseSettings& settings, int k) {
  TeQuad cosine = TeQuad(8) / 17;
  TeQuad sine = TeQuad(15) / 17;
  TeQuad cells = 1 / TeQuad(settings.wavelength);
  for (int i = 0; i < k; ++i) {
    const TeQuad turned = (4 * cosine - 3 * sine) / 5;
    sine = (3 * cosine + 4 * sine) / 5;
    cosine = turned;
    if (cosine <= 0) {
      cosine = sine;
      sine = -turned;
    }
    cells *= settings.lacunarity;
  }
  return {cosine * cells, sine * cells};
}

} // namespace

TeNoiseReference::TeNoiseReference(const TeNoiseSettings& settings, std::uint64_t worldSeed, double spacing)
    : m_settings(settings), m_plan(settings, worldSeed, spacing) {}

TeNoiseReference::Gradient TeNoiseReference::gradient(const TeNoiseOctave& octave, std::uint64_t cellX,
                                                      std::uint64_t cellY) {
  std::uint64_t z = line(cellX, octave.seedX) + line(cellY, octave.seedY);
  z ^= z >> 32;
  z *= 0xBF58476D1CE4E5B9u;
  const std::int64_t angle = std::int32_t(std::uint32_t(z >> 32)); // in π·2^-31
  std::int64_t quarterOn = angle + (std::int64_t(1) << 30);
  if (quarterOn >= std::int64_t(1) << 31)
    quarterOn -= std::int64_t(1) << 32;
  const TeQuad unit = TeQuad(1) / (std::int64_t(1) << 31);
  return {sine(TeQuad(quarterOn) * unit), sine(TeQuad(angle) * unit)};
}

TeNoiseReference::Place TeNoiseReference::place(TeNoiseCoordinate coordinate, TeQuad displacement) {
  const TeQuad fraction = TeQuad(std::uint64_t(coordinate)) * 0x1p-64 + displacement;
  std::int64_t whole = std::int64_t(fraction);
  if (TeQuad(whole) > fraction)
    --whole;
  return {std::uint64_t(coordinate >> 64) + std::uint64_t(whole), fraction - TeQuad(whole)};
}

TeQuad TeNoiseReference::rawNoise(const TeNoiseOctave& octave, Place x, Place y) {
  TeQuad corner[2][2];
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const Gradient g = gradient(octave, x.cell + std::uint64_t(i), y.cell + std::uint64_t(j));
      corner[j][i] = g.x * (x.fraction - i) + g.y * (y.fraction - j);
    }
  const TeQuad v = fade(y.fraction);
  return lerp(fade(x.fraction), lerp(v, corner[0][0], corner[1][0]), lerp(v, corner[0][1], corner[1][1]));
}

TeQuad TeNoiseReference::octaveNoise(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY,
                                     TeQuad displacementX, TeQuad displacementY) const {
  const TeNoiseCoordinate x =
      TeNoiseCoordinate(halfX) * octave.along + TeNoiseCoordinate(halfY) * octave.across + octave.offsetX;
  const TeNoiseCoordinate y =
      TeNoiseCoordinate(halfY) * octave.along - TeNoiseCoordinate(halfX) * octave.across + octave.offsetY;
  return TeNoisePlan::kUnit * rawNoise(octave, place(x, displacementX), place(y, displacementY));
}

TeQuad TeNoiseReference::field(const TeNoiseOctave* octaves, int count, std::int64_t halfX,
                               std::int64_t halfY) const {
  TeQuad sum = 0;
  TeQuad weights = 0;
  TeQuad weight = 1;
  for (int k = 0; k < count; ++k, weight *= m_settings.gain) {
    sum += weight * octaveNoise(octaves[k], halfX, halfY, 0, 0);
    weights += weight;
  }
  return sum / weights;
}

TeQuad TeNoiseReference::height(std::int64_t halfX, std::int64_t halfY) const {
  const TeQuad amplitude = m_settings.amplitude;
  if (m_settings.type == TeNoiseType::Fbm)
    return amplitude * field(m_plan.octaves, m_settings.octaves, halfX, halfY);

  TeQuad east = 0;
  TeQuad north = 0;
  if (m_settings.type == TeNoiseType::Warp) {
    const TeQuad displacement = TeQuad(m_settings.warp) * m_settings.wavelength;
    east = displacement * field(m_plan.warpX, m_settings.warpOctaves, halfX, halfY);
    north = displacement * field(m_plan.warpY, m_settings.warpOctaves, halfX, halfY);
  }
  TeQuad sum = 0;
  TeQuad weights = 0;
  TeQuad weight = 1;
  TeQuad ridge = 1;
  for (int k = 0; k < m_settings.octaves; ++k, weight *= m_settings.gain) {
    const Turn t = turn(m_settings, k);
    TeQuad signal = octaveNoise(m_plan.octaves[k], halfX, halfY, east * t.along + north * t.across,
                                north * t.along - east * t.across);
    if (m_settings.type == TeNoiseType::Ridged) {
      const TeQuad fold = 1 - magnitude(signal);
      signal = fold * fold * ridge;
      ridge = m_settings.sharpness * signal < 1 ? m_settings.sharpness * signal : TeQuad(1);
    }
    sum += weight * signal;
    weights += weight;
  }
  return m_settings.type == TeNoiseType::Ridged ? amplitude * (2 * sum / weights - 1)
                                                : amplitude * sum / weights;
}
