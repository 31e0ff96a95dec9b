#pragma once

#include "generators/base/TeResult.h"

#include <nlohmann/json.hpp>

#include <string>

/// What the samples of headerless files mean, in a small JSON file beside them: `NAME.json` for the pyramid
/// NAME, `NAME.raw.json` for the file NAME.raw.
struct TeTerrainDescription {
  int samples = 0; ///< a side
  int sampleBytes = 2;
  double spacing = 0;      ///< metres between samples; 0 = not known
  double heightUnit = 0;   ///< metres of a step; 0 = not known
  double heightOffset = 0; ///< metres of sample 0
  bool colour = false;
  int levels = 0; ///< of a pyramid; 0 for a single file
  nlohmann::ordered_json source;

  static std::string besideRaw(const std::string& file) { return file + ".json"; }
  static std::string besidePyramid(const std::string& name) { return name + ".json"; }

  TeStatus write(const std::string& path) const;
  /// Takes spacing, unit and offset from a file, as far as it has them; nothing where there is none. Error:
  /// not such a file, or numbers that cannot be.
  TeStatus readIfThere(const std::string& path);
};
