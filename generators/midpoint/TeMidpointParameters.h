#pragma once

#include "generators/TeParameter.h"

#include <cstdint>
#include <string>

/// The parameters of midpoint displacement.
struct TeMidpointParameters {
  /// `uniform`: displacements uniform in [-d, d) (document 002); `gaussian`: normal with standard deviation d
  /// (document 000).
  std::string variant = "uniform";
  double displacement = 8; ///< d of the corners and of the first centre, metres, 0 .. 1e6
  double fall = 0.55;      ///< factor of d from one level of recursion to the next, 0 .. 1
  std::uint64_t seed = 0;  ///< of the generator's own, besides the world's

  /// The table that binds these members.
  TeParameters table();
};
