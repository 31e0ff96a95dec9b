#pragma once

#include "generators/TeHeightSource.h"
#include "generators/noise/TeNoiseSettings.h"

#include <cstdint>

/// A coordinate in lattice cells: 64 bits of cell number, 64 bits of fraction, modulo 2^64 cells. Sums and
/// products with integers are exact, so a position is the same from whatever sample it was reached.
__extension__ using TeNoiseCoordinate = unsigned __int128;

/// One octave over the samples of a world. The sample that lies hx, hy half cells of the sample lattice from
/// the world's origin has the noise-lattice coordinates, exactly:
///
///     x = hx·along + hy·across + offsetX
///     y = hy·along - hx·across + offsetY
struct TeNoiseOctave {
  TeNoiseCoordinate along = 0; ///< below half a cell, or no row is walked (TeNoiseLoops.inl)
  TeNoiseCoordinate across = 0;
  TeNoiseCoordinate offsetX = 0;
  TeNoiseCoordinate offsetY = 0;
  std::uint64_t seedX = 0;
  std::uint64_t seedY = 0;
  double amplitude = 0;  ///< factor of the raw noise
  double alongMetre = 0; ///< as `along` and `across`, cells per metre, for displacements
  double acrossMetre = 0;
};

/// Everything that gradient noise computes a height from, apart from the sample: settings, world seed and
/// sample spacing. A value; cheap to make (about 0.2 µs) and to copy.
///
/// *Raw noise* of an octave (Perlin, "Improving Noise", 2002, with a gradient of its own per lattice point):
/// with cell (c, d) and fractions (x, y) of the coordinates, u = fade(x), v = fade(y),
/// fade(t) = 6t⁵ - 15t⁴ + 10t³,
///
///     n = lerp(u, lerp(v, g(c,d)·(x,y), g(c,d+1)·(x,y-1)), lerp(v, g(c+1,d)·(x-1,y), g(c+1,d+1)·(x-1,y-1)))
///
/// The gradient g has the angle of 32 hashed bits and, within 0.11 %, the length 1 (its components are a
/// polynomial of the angle: no libm). |n| ≤ 1/kUnit.
///
/// With a_k = gain^k / Σ gain^i, unit noise m_k = kUnit·n_k and A = amplitude:
/// * Fbm: height = A·Σ a_k·m_k.
/// * Ridged (Musgrave 1994): s_k = (1 - |m_k|)²·w_k, w_0 = 1, w_(k+1) = min(1, sharpness·s_k);
///   height = A·(2·Σ a_k·s_k - 1).
/// * Warp: the Fbm height at (x + dx, y + dy), dx and dy two further Fbm fields of amplitude
///   warp·wavelength and `warpOctaves` octaves.
///
/// The wavelength of octave k is wavelength / lacunarity^k. Its lattice has an angle and a random offset of
/// its own, so that neither the axes along which gradient noise is stiff nor the points where it is zero fall
/// together: aligned lattices give a visible weave. Steps are rounded down to a multiple of 2^-64 cells once,
/// here, and exact from there on.
struct TeNoisePlan {
  /// √2, less the 0.11 % by which gradients may be too long.
  static constexpr double kUnit = 1.4126;

  TeNoisePlan(const TeNoiseSettings& settings, std::uint64_t worldSeed, double spacing);

  TeNoiseType type;
  int octaveCount;
  int warpOctaveCount; ///< 0 unless type is Warp
  double base;         ///< what the sum starts from, metres
  double sharpness;
  TeNoiseOctave octaves[TeNoiseSettings::kMaxOctaves];
  TeNoiseOctave warpX[TeNoiseSettings::kMaxOctaves];
  TeNoiseOctave warpY[TeNoiseSettings::kMaxOctaves];
};
