#pragma once

#include "apps/terrane-accuracy/TeGenerationDial.h"
#include "apps/terrane-accuracy/TeSpread.h"

#include <optional>

/// One value of a dial.
struct TeGenerationFigures {
  std::string generator;
  std::string dial;
  double value = 0;
  bool isReference = false;
  bool inDouble = false; ///< the plain formula in double precision
  TeSpread ms;           ///< CPU time of a map
  double ratio = 0;      ///< median of the runs' ratios to the reference, measured in turn with it
  /// Differences of heights from the reference's, as shares of its relief (highest less lowest sample): root
  /// mean square, and the largest. None where heights do not come nearer to it.
  std::optional<double> rms;
  std::optional<double> worst;
  /// Of the spectrum over all maps, by octaves of wavelength, dB (TeRadialSpectrum::difference).
  std::optional<double> spectrumDecibels;
};

/// How many maps are looked at, and how often each value is timed.
struct TeGenerationEffort {
  int samples = 257; ///< a side: 2^n + 1
  int maps = 4;
  int runs = 9;
};

/// All values of a dial and its reference, then the two arithmetics if it has them: "float" against the plain
/// formula in double precision.
std::vector<TeGenerationFigures> teMeasureGeneration(const TeGenerationDial& dial,
                                                     const TeGenerationEffort& effort);
