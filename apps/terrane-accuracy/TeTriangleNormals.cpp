#include "apps/terrane-accuracy/TeTriangleNormals.h"

#include "patchdb/TeSurfaceNormals.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace {

/// From a sample to the corners of the six triangles around it, counter-clockwise from the east.
struct Star {
  glm::dvec3 to[6];
};

Star starOf(const TeHeightMap& heights, int column, int row, int step, double spacing) {
  constexpr int kColumns[6] = {1, 1, 0, -1, -1, 0};
  constexpr int kRows[6] = {0, 1, 1, 0, -1, -1};
  const double reach = step * spacing;
  const double here = heights.at(column, row);
  Star star;
  for (int i = 0; i < 6; ++i)
    star.to[i] = {kColumns[i] * reach, kRows[i] * reach,
                  heights.at(column + kColumns[i] * step, row + kRows[i] * step) - here};
  return star;
}

glm::dvec3 byArea(const Star& star) {
  glm::dvec3 sum(0);
  for (int i = 0; i < 6; ++i)
    sum += glm::cross(star.to[i], star.to[(i + 1) % 6]);
  return glm::normalize(sum);
}

glm::dvec3 byAngle(const Star& star) {
  glm::dvec3 sum(0);
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 cross = glm::cross(star.to[i], star.to[(i + 1) % 6]);
    const double length = glm::length(cross);
    sum += cross * (std::atan2(length, glm::dot(star.to[i], star.to[(i + 1) % 6])) / length);
  }
  return glm::normalize(sum);
}

glm::vec3 inFloat(float west, float east, float south, float north, float twice) {
  const float x = west - east, y = south - north;
  const float scale = 1 / std::sqrt(x * x + y * y + twice * twice);
  return {x * scale, y * scale, twice * scale};
}

/// One of a row of samples.
template <TeNormalWay way>
glm::vec3 normal(const TeHeightMap& heights, int column, int row, int step, double spacing) {
  const float west = heights.at(column - step, row), east = heights.at(column + step, row);
  const float south = heights.at(column, row - step), north = heights.at(column, row + step);
  const float here = heights.at(column, row);
  switch (way) {
  case TeNormalWay::Central:
    return teSampleNormal(here, west, east, south, north, step * spacing);
  case TeNormalWay::CentralFloat:
    return inFloat(west, east, south, north, float(2 * step * spacing));
  case TeNormalWay::Area:
    return glm::vec3(byArea(starOf(heights, column, row, step, spacing)));
  case TeNormalWay::Angle:
    return glm::vec3(byAngle(starOf(heights, column, row, step, spacing)));
  case TeNormalWay::Face:
    break;
  }
  return glm::vec3(
      glm::normalize(glm::dvec3(double(here) - double(east), double(here) - double(north), step * spacing)));
}

template <TeNormalWay way>
void fill(const TeHeightMap& heights, int first, int end, int stepOfVertices, int step, double spacing,
          glm::vec3* normals) {
  for (int row = first; row < end; row += stepOfVertices)
    for (int column = first; column < end; column += stepOfVertices)
      *normals++ = normal<way>(heights, column, row, step, spacing);
}

} // namespace

const char* teNameOf(TeNormalWay way) {
  const char* const names[] = {"central", "central in float", "area-weighted", "angle-weighted", "one face"};
  return names[int(way)];
}

glm::dvec3 teNormalBy(TeNormalWay way, const TeHeightMap& heights, int column, int row, int step,
                      double spacing) {
  if (way == TeNormalWay::Area)
    return byArea(starOf(heights, column, row, step, spacing));
  if (way == TeNormalWay::Angle)
    return byAngle(starOf(heights, column, row, step, spacing));
  const auto unit = [](const glm::vec3& rounded) { return glm::normalize(glm::dvec3(rounded)); };
  if (way == TeNormalWay::Central)
    return unit(normal<TeNormalWay::Central>(heights, column, row, step, spacing));
  if (way == TeNormalWay::CentralFloat)
    return unit(normal<TeNormalWay::CentralFloat>(heights, column, row, step, spacing));
  return unit(normal<TeNormalWay::Face>(heights, column, row, step, spacing));
}

void teNormalsBy(TeNormalWay way, const TeHeightMap& heights, int first, int end, int stepOfVertices,
                 int step, double spacing, glm::vec3* normals) {
  switch (way) {
  case TeNormalWay::Central:
    // All samples of a block: as patches are made.
    if (stepOfVertices == 1 && step == 1)
      return teGridNormals(heights.row(first) + first, heights.width(), end - first, end - first, spacing,
                           false, normals);
    return fill<TeNormalWay::Central>(heights, first, end, stepOfVertices, step, spacing, normals);
  case TeNormalWay::CentralFloat:
    return fill<TeNormalWay::CentralFloat>(heights, first, end, stepOfVertices, step, spacing, normals);
  case TeNormalWay::Area:
    return fill<TeNormalWay::Area>(heights, first, end, stepOfVertices, step, spacing, normals);
  case TeNormalWay::Angle:
    return fill<TeNormalWay::Angle>(heights, first, end, stepOfVertices, step, spacing, normals);
  case TeNormalWay::Face:
    return fill<TeNormalWay::Face>(heights, first, end, stepOfVertices, step, spacing, normals);
  }
}
