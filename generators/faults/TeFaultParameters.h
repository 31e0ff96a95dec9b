#pragma once

#include "generators/TeParameter.h"

#include <cstdint>
#include <string>

/// The parameters of fault formation.
///
/// Fault i of N raises by a(i) = first / (1 + i·c)², where c is such that a(N-1) = last: large at first, so
/// that some few faults sketch the land, then ever smaller. (A fall with the inverse square leaves to each
/// octave of amplitudes a share of the variance in proportion to its 1.5th power, a Hurst exponent of 0.75,
/// about that of mountains.)
struct TeFaultParameters {
  int faults = 150;             ///< N, 1 .. 100000
  double first = 2.5;           ///< metres by which the first fault raises one side, 1e-6 .. 1e6
  double last = 0.25;           ///< metres by which the last fault does, 1e-6 .. 1e6
  std::string profile = "step"; ///< `step`: a cliff along the line; `smooth`: a ramp across it
  /// Metres across the ramp of the first fault, up to 1e6; the others' are narrower in proportion to their
  /// amplitude, so that all are equally steep. A ramp is at least 1 and at most 4096 samples wide.
  double width = 12;
  /// Start from minus half of the sum of all amplitudes, the mean height over all maps being 0; otherwise
  /// from 0, the mean being half of the sum.
  bool centred = true;
  std::uint64_t seed = 0; ///< of the generator's own, besides the world's

  /// The table that binds these members.
  TeParameters table();
};
