#pragma once

#include "apps/terrane-static/TeStaticOptions.h"
#include "patchdb/TePatchDatabase.h"

#include <glm/vec2.hpp>

#include <string>

/// The world that the options ask for, and where in it the block lies.
struct TeStaticWorld {
  TeWorld world;
  glm::dvec2 centre{0};
  std::string description; ///< of the generator or file, for the report

  /// Opens the elevation file if there is one. Error: whatever is wrong with the options.
  static TeResult<TeStaticWorld> create(const TeStaticOptions& options, std::uint64_t seed);
};
