#pragma once

#include "apps/terrane-view/TeDemMap.h"
#include "apps/terrane-view/TeViewOptions.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoSeparator.h>

#include <glm/vec3.hpp>

#include <memory>

/// One terrain drawn by Seamless Patches, around the origin, as the options say.
struct TeTerrainScene {
  TeNodePtr<SoSeparator> root;
  // Of the map that is the ground: all heights, or a coarse level of the pyramid.
  std::shared_ptr<const TeHeightMap> coarse;
  glm::dvec3 corner{0};
  double spacing = 1;
  double heightScale = 1;

  /// Error: options that do not suit the map.
  static TeResult<TeTerrainScene> fromMap(const TeDemMap& dem, const TeViewOptions& options);
  /// Reads NAME.json for spacing and scale if it is there. Error: no pyramid, files that do not fit it.
  static TeResult<TeTerrainScene> fromPyramid(const TeViewOptions& options);
};
