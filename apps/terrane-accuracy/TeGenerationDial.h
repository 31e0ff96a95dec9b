#pragma once

#include "generators/TeHeightMap.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// One generator or filter with what makes its maps better and slower: a number of faults, octaves, passes …
struct TeGenerationDial {
  /// The same land in other arithmetic: how far single precision is from double.
  struct Arithmetic {
    double value = 0; ///< of the dial
    std::function<std::vector<double>(std::uint64_t seed)> inDouble;
    std::function<void()> work; ///< that is timed; empty: inDouble
  };

  std::string generator;
  std::string name;           ///< of the dial, as in the diagrams
  std::vector<double> values; ///< rising
  double reference = 0;       ///< the value that is taken for converged; more than all others
  /// Whether heights come nearer to the reference's, sample by sample; else their spectrum alone does.
  bool converges = true;
  std::function<TeHeightMap(double value, std::uint64_t seed)> make;
  /// The work that is timed; empty: make.
  std::function<void(double value, std::uint64_t seed)> work;
  Arithmetic arithmetic; ///< if it has any in single precision
};

/// Of all generators and filters of ours that have a dial: fault formation, circles, midpoint displacement,
/// noise and the band filter, over maps of `samples` (2^n + 1) a side, 1 m apart.
std::vector<TeGenerationDial> teGenerationDials(int samples);
