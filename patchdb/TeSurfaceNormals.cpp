#include "patchdb/TeSurfaceNormals.h"

#include "generators/TeHeightMap.h"
#include "patchdb/TeTargetClones.h"

#include <cmath>

namespace {

/// before - after, from what is there.
double fall(double before, double here, double after) {
  const bool noBefore = std::isnan(before);
  const bool noAfter = std::isnan(after);
  if (noBefore && noAfter)
    return 0;
  if (noBefore)
    return 2 * (here - after);
  if (noAfter)
    return 2 * (before - here);
  return before - after;
}

glm::vec3 normalOfFalls(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {float(x / length), float(y / length), float(z / length)};
}

/// One row of a block without missing samples.
TE_TARGET_CLONES
void normalRow(const float* south, const float* row, const float* north, int columns, double z, float* out) {
  for (int x = 0; x < columns; ++x) {
    const double fallX = double(row[x - 1]) - double(row[x + 1]);
    const double fallY = double(south[x]) - double(north[x]);
    const double length = std::sqrt(fallX * fallX + fallY * fallY + z * z);
    out[3 * x] = float(fallX / length);
    out[3 * x + 1] = float(fallY / length);
    out[3 * x + 2] = float(z / length);
  }
}

} // namespace

glm::vec3 teSampleNormal(float here, float west, float east, float south, float north, double spacing) {
  if (TeHeightMap::isMissing(here))
    return {0, 0, 1};
  return normalOfFalls(fall(west, here, east), fall(south, here, north), 2 * spacing);
}

void teGridNormals(const float* heights, int stride, int columns, int rows, double spacing, bool missing,
                   glm::vec3* normals) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "normals are written as plain floats");
  for (int y = 0; y < rows; ++y, heights += stride, normals += columns) {
    if (!missing) {
      normalRow(heights - stride, heights, heights + stride, columns, 2 * spacing, &normals->x);
      continue;
    }
    for (int x = 0; x < columns; ++x)
      normals[x] = teSampleNormal(heights[x], heights[x - 1], heights[x + 1], heights[x - stride],
                                  heights[x + stride], spacing);
  }
}
