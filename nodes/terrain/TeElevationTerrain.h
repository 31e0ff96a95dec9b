#pragma once

#include "generators/TeHeightSource.h"
#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TeElevationSource.h"

#include <glm/vec2.hpp>

#include <string>

/// How a block of patches is to lie over an elevation file.
struct TeElevationTerrainOptions {
  std::string file;
  TeElevationOptions reading;
  TeElevationOutside outside = TeElevationOutside::Hole;
  float outsideHeight = 0;         ///< Constant: metres
  TeHeightSourcePtr outsideSource; ///< Generator
  bool native = false;             ///< samples are the file's posts, the highest one at the world's origin
  int patches = 3;                 ///< a side of the block
  int samples = 0;    ///< a side of a source map; 0 = as many as the file's posts, up to kMostSamples
  double spacing = 0; ///< metres; 0 = such that the block covers the file. With native: the file's, always
};

/// An elevation file as terrain for a block.
struct TeElevationTerrain {
  static constexpr int kMostSamples = 513; ///< chosen by itself

  TeHeightSourcePtr source;
  int samples = 0;      ///< a side of a source map
  double spacing = 1;   ///< metres
  glm::dvec2 centre{0}; ///< of the block, where the file's centre lies

  /// Error: the file cannot be read, has no one spacing (native), or the sizes are out of range.
  static TeResult<TeElevationTerrain> open(const TeElevationTerrainOptions& options);
};
