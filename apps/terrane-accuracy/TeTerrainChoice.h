#pragma once

#include "apps/common/TeDemReading.h"
#include "apps/terrane-accuracy/TeMeasuredTerrain.h"

#include <CLI/CLI.hpp>

/// The options that say on which terrain is measured.
struct TeTerrainChoice {
  std::string map; ///< file of 16 bit samples
  double cells = 10;
  double heightUnit = 0.03;
  std::string dem;
  TeDemReading reading;

  void addTo(CLI::App& command);
  /// Error: none or two given, a file that cannot be used.
  TeResult<TeMeasuredTerrain> read() const;
  /// Mountains of so many samples a side if none is given.
  TeResult<TeMeasuredTerrain> readOrMountains(int samples) const;
};
