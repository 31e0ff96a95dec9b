#pragma once

#include "apps/common/TeCommandLine.h"
#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeResult.h"
#include "patchdb/TeBlendWeights.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

/// What terrane-static is asked for besides the common options.
struct TeStaticOptions {
  static constexpr int kMaxBlock = 255;
  static constexpr int kMaxSamples = 8193;

  int block = 3;                                                  ///< patches a side
  int samples = 0;                                                ///< a side of a source map; 0 = as suits
  double spacing = 0;                                             ///< metres; 0 = as suits
  glm::dvec2 center{0};                                           ///< a point of the middle patch, metres
  std::string generator = TeGeneratorRegistry::kDefaultGenerator; ///< specification
  std::vector<std::string> filters;
  TeBlendProfile blending = TeBlendProfile::Smooth;
  bool listGenerators = false;

  std::string dem;                   ///< elevation file; empty = none
  std::string verticalUnit = "auto"; ///< of its heights
  double posts = 0;                  ///< metres between its posts; 0 = as the file says
  bool fillVoids = false;
  std::string outside = "hole"; ///< hole, clamp, a height, or a generator's specification
  bool native = false;

  double verticalScale = 1;
  bool wireframe = false;
  bool parts = false;
  bool top = false;
  std::optional<double> water; ///< metres
  std::string drape;           ///< PNG picture
  std::string exportFile;      ///< .iv file

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts what; after parsing.
  TeStatus check() const;

private:
  void addTerrain(TeCommandLine& commandLine);
  void addElevationData(TeCommandLine& commandLine);
  void addView(TeCommandLine& commandLine);
};
