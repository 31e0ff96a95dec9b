#pragma once

#include "apps/terrane-accuracy/TeSpread.h"
#include "apps/terrane-accuracy/TeTriangleNormals.h"

#include <functional>
#include <vector>

/// A surface with normals that are taken for true.
struct TeNormalsTerrain {
  std::string name;
  std::string reference;      ///< what its true normals are
  const TeHeightMap* heights; ///< metres; a square, none missing
  double spacing = 1;
  std::function<glm::dvec3(int column, int row)> exact; ///< of samples that are not on the rim
};

/// One way of making normals for the vertices of one level.
struct TeNormalsFigures {
  TeNormalWay way = TeNormalWay::Central;
  int level = 0;
  bool fromFine = true; ///< from all samples, else from the vertices of the level alone
  std::int64_t vertices = 0;
  TeSpread ns;      ///< CPU time of a vertex
  double ratio = 0; ///< to central differences of level 0: median of runs in turn
  /// Angles from the true normals, degrees: at the vertices; and at all samples, where a renderer
  /// interpolates between the vertices of a triangle and makes the length 1 again.
  double meanAtVertices = 0;
  double worstAtVertices = 0;
  double mean = 0;
  double worst = 0;
};

/// All ways at levels 0 .. levels-1, of which each has a vertex every 2^level samples: as many as fit.
std::vector<TeNormalsFigures> teMeasureNormals(const TeNormalsTerrain& terrain, int levels, int runs);
