#pragma once

#include "generators/TeParameter.h"

#include <cstdint>

/// The parameters of the circles algorithm.
struct TeCirclesParameters {
  int circles = 1000;     ///< 1 .. 1000000
  double smallest = 3;    ///< least radius, metres, 1e-6 .. 1e6; in samples at least 1 and at most 16384
  double largest = 20;    ///< greatest radius, likewise
  double height = 3;      ///< greatest height of a hill of the greatest radius, metres, 0 .. 1e6
  std::uint64_t seed = 0; ///< of the generator's own, besides the world's

  /// The table that binds these members.
  TeParameters table();
};
