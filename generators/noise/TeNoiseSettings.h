#pragma once

#include "generators/TeParameter.h"

#include <cstdint>

enum class TeNoiseType {
  Fbm,    ///< sum of octaves: rolling hills
  Ridged, ///< sum of folded, squared octaves, each weighted by the one before: mountain crests
  Warp    ///< fBm at positions that two other fBm fields displace: folded, eroded-looking land
};

/// What gradient noise is made of; the formulas are in TeNoisePlan.h, the ranges in parameters().
struct TeNoiseSettings {
  static constexpr int kMaxOctaves = 16;

  TeNoiseType type = TeNoiseType::Fbm;
  int octaves = 8;
  double wavelength = 200; ///< side of a lattice cell of the first octave, metres
  double amplitude = 40;   ///< heights lie in ±amplitude, metres
  double lacunarity = 2;   ///< ratio of the wavelengths of successive octaves
  double gain = 0.5;       ///< ratio of the amplitudes of successive octaves
  double sharpness = 2;    ///< of Ridged: weight of an octave per signal of the one before
  double warp = 0.2;       ///< of Warp: the largest displacement in x and in y, wavelengths
  int warpOctaves = 3;     ///< of Warp: octaves of the displacement; its first has the wavelength above
  std::uint64_t seed = 0;  ///< tells apart noises of one world

  /// All but the type, bound to this object.
  TeParameters parameters();
  /// Error: a number is out of its range.
  TeStatus check() const;
};
