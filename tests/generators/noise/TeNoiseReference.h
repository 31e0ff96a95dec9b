#pragma once

#include "generators/noise/TeNoisePlan.h"

#include <cstdint>

/// 113 significant bits: far more than any path of the noise uses.
#if defined(__SIZEOF_FLOAT128__)
__extension__ using TeQuad = __float128;
#else
using TeQuad = long double;
#endif

/// Gradient noise as TeNoisePlan.h defines it, in 128-bit arithmetic, one sample at a time. Shares with the
/// library the plan's integers (steps, offsets, seeds) and nothing else: amplitudes and displacements come
/// from the settings, hashes and polynomials are written out again.
class TeNoiseReference {
public:
  TeNoiseReference(const TeNoiseSettings& settings, std::uint64_t worldSeed, double spacing);

  TeQuad height(std::int64_t halfX, std::int64_t halfY) const;

  struct Gradient {
    TeQuad x, y;
  };
  /// The gradient at a lattice point of an octave.
  static Gradient gradient(const TeNoiseOctave& octave, std::uint64_t cellX, std::uint64_t cellY);

private:
  struct Place {
    std::uint64_t cell;
    TeQuad fraction;
  };
  static Place place(TeNoiseCoordinate coordinate, TeQuad displacement);
  static TeQuad rawNoise(const TeNoiseOctave& octave, Place x, Place y);
  TeQuad octaveNoise(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY,
                     TeQuad displacementX, TeQuad displacementY) const;
  TeQuad field(const TeNoiseOctave* octaves, int count, std::int64_t halfX, std::int64_t halfY) const;

  TeNoiseSettings m_settings;
  TeNoisePlan m_plan;
};
