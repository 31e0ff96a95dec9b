#pragma once

#include <vector>

/// Many measurements of one quantity in a few numbers, as single ones may be disturbed by other programs.
struct TeSpread {
  double median = 0;
  double low = 0; ///< a quarter of the measurements is less, a quarter more than `high`
  double high = 0;
  double mean = 0;

  /// All 0 of no values.
  static TeSpread of(std::vector<double> values);
};
