#pragma once

#include "generators/TeHeightMap.h"

#include <glm/vec3.hpp>

/// Ways to the normal of a sample of a height map whose cells are split along their SW-NE diagonals.
enum class TeNormalWay {
  Central,      ///< central differences in double, rounded once: what the engine draws (TeSurfaceNormals)
  CentralFloat, ///< the same in float throughout
  Area,         ///< sum of the six triangles' normals by their areas
  Angle,        ///< by their angles at the sample (Thürmer and Wüthrich 1998)
  Face          ///< of one triangle, to the north-east: what forward differences give
};
constexpr TeNormalWay kTeNormalWays[] = {TeNormalWay::Central, TeNormalWay::CentralFloat, TeNormalWay::Area,
                                         TeNormalWay::Angle, TeNormalWay::Face};
const char* teNameOf(TeNormalWay way);

/// Of sample (column, row), whose eight neighbours `step` samples away must be in the map; `spacing` metres
/// between samples, heights in metres. Unit length.
glm::dvec3 teNormalBy(TeNormalWay way, const TeHeightMap& heights, int column, int row, int step,
                      double spacing);

/// Of the samples first, first + step … < end, in both directions, by rows: as a renderer would make them.
void teNormalsBy(TeNormalWay way, const TeHeightMap& heights, int first, int end, int stepOfVertices,
                 int step, double spacing, glm::vec3* normals);
