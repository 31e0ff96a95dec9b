#include "generators/noise/TeNoisePlan.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeRandom.h"

namespace {

/// Rounded down to a multiple of 2^-64. A step past 2^62 cells means nothing; it is held there.
TeNoiseCoordinate toCoordinate(double cells) {
  cells = cells < 0x1p62 ? cells : 0x1p62;
  const std::uint64_t whole = std::uint64_t(cells);
  const std::uint64_t fraction = std::uint64_t((cells - double(whole)) * 0x1p64);
  return (TeNoiseCoordinate(whole) << 64) | fraction;
}

/// The octaves of one field. `amplitude` is what the unit noises' weights sum to.
void setOctaves(TeNoiseOctave* octaves, int count, const TeNoiseSettings& settings, double amplitude,
                const TeRandom& random, double spacing) {
  double weights = 0;
  double weight = 1;
  for (int k = 0; k < count; ++k, weight *= settings.gain)
    weights += weight;

  // The angles 61.9° + k·36.9°: modulo the lattice's 90° they spread evenly, and the first eight keep 7° from
  // the axes of the samples. The components are rationals, 8/17, 15/17, 4/5, 3/5: no libm.
  double cosine = 8.0 / 17.0;
  double sine = 15.0 / 17.0;
  double cellsPerMetre = 1 / settings.wavelength;
  weight = 1;
  for (int k = 0; k < count; ++k) {
    TeNoiseOctave& octave = octaves[k];
    const std::uint64_t draw = std::uint64_t(k) * 8;
    octave.alongMetre = cosine * cellsPerMetre;
    octave.acrossMetre = sine * cellsPerMetre;
    octave.along = toCoordinate(octave.alongMetre * (0.5 * spacing));
    octave.across = toCoordinate(octave.acrossMetre * (0.5 * spacing));
    octave.offsetX = (TeNoiseCoordinate(random.at(draw)) << 64) | random.at(draw + 1);
    octave.offsetY = (TeNoiseCoordinate(random.at(draw + 2)) << 64) | random.at(draw + 3);
    octave.seedX = random.at(draw + 4);
    octave.seedY = random.at(draw + 5);
    octave.amplitude = amplitude * (weight / weights);
    weight *= settings.gain;
    cellsPerMetre *= settings.lacunarity;
    const double turned = 0.8 * cosine - 0.6 * sine;
    sine = 0.6 * cosine + 0.8 * sine;
    cosine = turned;
    if (cosine <= 0) { // a quarter turn back: the lattice is the same
      cosine = sine;
      sine = -turned;
    }
  }
}

} // namespace

TeNoisePlan::TeNoisePlan(const TeNoiseSettings& settings, std::uint64_t worldSeed, double spacing)
    : type(settings.type), octaveCount(settings.octaves),
      warpOctaveCount(settings.type == TeNoiseType::Warp ? settings.warpOctaves : 0),
      base(settings.type == TeNoiseType::Ridged ? -settings.amplitude : 0), sharpness(settings.sharpness) {
  const std::uint64_t domain = teHashCombine(teHashText("noise"), settings.seed);
  const auto field = [&](std::uint64_t number) {
    return TeRandom(worldSeed, teHashCombine(domain, number), TeMapKey{});
  };
  const double amplitude = type == TeNoiseType::Ridged ? 2 * settings.amplitude : settings.amplitude * kUnit;
  const double displacement = settings.warp * settings.wavelength * kUnit;
  setOctaves(octaves, octaveCount, settings, amplitude, field(0), spacing);
  setOctaves(warpX, warpOctaveCount, settings, displacement, field(1), spacing);
  setOctaves(warpY, warpOctaveCount, settings, displacement, field(2), spacing);
}
