#pragma once

#include "apps/common/TeTerrainOptions.h"
#include "patchdb/TePatchDatabase.h"

#include <glm/vec2.hpp>

#include <string>

/// The world that the options of an application ask for, and where in it to begin.
struct TeAppWorld {
  TeWorld world;
  TeHeightSourcePtr source; ///< the one of the whole world, filters included
  glm::dvec2 centre{0};     ///< of a block that covers an elevation file; else (0, 0)
  std::string description;  ///< of the generator or file, for the report

  /// Opens the elevation file if there is one and lays so many patches a side over it, unless the options
  /// give a spacing. Error: whatever is wrong with the options.
  static TeResult<TeAppWorld> create(const TeTerrainOptions& options, int patches, std::uint64_t seed);
};
