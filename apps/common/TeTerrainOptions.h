#pragma once

#include "apps/common/TeDemReading.h"
#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TeBlendWeights.h"

#include <string>
#include <vector>

/// The options that say of which terrain a world is made: generator, filters, elevation file, sizes.
struct TeTerrainOptions {
  static constexpr int kMaxSamples = 8193;

  int samples = 0;                                                ///< a side of a source map; 0 = as suits
  double spacing = 0;                                             ///< metres; 0 = as suits
  std::string generator = TeGeneratorRegistry::kDefaultGenerator; ///< specification
  std::vector<std::string> filters;
  TeBlendProfile blending = TeBlendProfile::Smooth;
  bool listGenerators = false;

  std::string dem; ///< elevation file; empty = none
  TeDemReading reading;
  std::string outside = "hole"; ///< hole, clamp, a height, or a generator's specification
  bool native = false;

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts what; after parsing.
  TeStatus check() const;

private:
  void addTerrain(TeCommandLine& commandLine);
  void addElevationData(TeCommandLine& commandLine);
};
