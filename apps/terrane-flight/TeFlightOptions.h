#pragma once

#include "apps/common/TeCommandLine.h"
#include "generators/base/TeResult.h"

#include <optional>
#include <string>

/// What terrane-flight is asked for besides the options of every application of the engine.
struct TeFlightOptions {
  static constexpr double kDefaultSpeed = 40; ///< m/s
  static constexpr double kMaxSpeed = 1e6;

  std::string path;            ///< a built-in path's name or a file; empty = the user flies
  std::optional<double> speed; ///< m/s
  /// Metres above the ground; none = such that the block's rim lies where one looks.
  std::optional<double> altitude;

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts what; after parsing.
  TeStatus check() const;
};
