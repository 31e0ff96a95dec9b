#pragma once

#include "apps/common/TeCommandLine.h"
#include "generators/elevation/TeElevationOptions.h"

#include <string>

/// The options that say how the file of --dem is read.
struct TeDemReading {
  static constexpr int kFillDistance = 100; ///< posts: the widest gap that --fill voids closes

  std::string verticalUnit = "auto"; ///< of its heights
  double posts = 0;                  ///< metres between its posts; 0 = as the file says
  bool fillVoids = false;

  /// Adds the options, which need --dem, to a command line.
  void addTo(CLI::App& cli, CLI::Option* dem, const std::string& group);
  /// Error: --vertical-unit is none.
  TeResult<TeElevationOptions> options() const;
};
