#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TeRasterFile.h"

#include <vector>

/// Stored samples to heights in metres. Missing are: what the file or the options declare as "no data" (for
/// single precision files compared in single precision), NaN, infinities, -32768 in signed 16 bit files and
/// where it would mean -32768 m, and whatever lies more than kMaxHeight metres above or below zero (such as
/// the largest float). Immutable.
class TePostDecoder {
public:
  static constexpr double kMaxHeight = 100000;

  TePostDecoder() = default;
  TePostDecoder(const TeRasterInfo& info, const TeElevationOptions& options, double metresPerStep);

  /// (sample · scale + offset) · metresPerStep, rounded once to float, or missing.
  float height(double sample) const;

private:
  std::vector<double> m_noData;
  bool m_signed16 = false;
  bool m_float32 = false;
  double m_scale = 1;
  double m_offset = 0;
  double m_metres = 1;
};
