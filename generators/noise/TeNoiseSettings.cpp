#include "generators/noise/TeNoiseSettings.h"

// Lacunarity, octaves and warp together keep every displacement below 2^51 lattice cells.
TeParameters TeNoiseSettings::parameters() {
  return {
      {"octaves", &octaves, 1, kMaxOctaves, {}, "number of octaves"},
      {"wavelength", &wavelength, 0.1, 1e9, {}, "lattice cell of the first octave, metres"},
      {"amplitude", &amplitude, 0, 1e6, {}, "heights lie in plus or minus this, metres"},
      {"lacunarity",
       &lacunarity,
       1,
       4,
       {},
       "each octave's wavelength is that of the one before divided by this"},
      {"gain", &gain, 0, 1, {}, "each octave's amplitude is that of the one before times this"},
      {"sharpness", &sharpness, 0, 16, {}, "ridged: how strongly crests keep later octaves to themselves"},
      {"warp", &warp, 0, 16, {}, "warp: largest displacement, wavelengths"},
      {"warp-octaves", &warpOctaves, 1, kMaxOctaves, {}, "warp: octaves of the displacement"},
      {"seed", &seed, 0, 0, {}, "tells apart noises of one world"},
  };
}

TeStatus TeNoiseSettings::check() const {
  TeNoiseSettings copy = *this;
  return teCheckParameters(copy.parameters(), "noise");
}
