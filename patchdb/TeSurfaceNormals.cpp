#include "patchdb/TeSurfaceNormals.h"

#include "generators/TeHeightMap.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>
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
  const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
  return {float(x * scale), float(y * scale), float(z * scale)};
}

constexpr int kRun = 64;

/// Up to kRun normals of a row without missing samples. Components go through buffers, so that the arithmetic
/// is vectorised though normals are stored one by one.
TE_TARGET_CLONES
void normalRun(const float* south, const float* row, const float* north, int count, double z, float* out) {
  float xs[kRun], ys[kRun], zs[kRun];
  for (int i = 0; i < count; ++i) {
    const double x = double(row[i - 1]) - double(row[i + 1]);
    const double y = double(south[i]) - double(north[i]);
    const double scale = 1.0 / std::sqrt(x * x + y * y + z * z);
    xs[i] = float(x * scale);
    ys[i] = float(y * scale);
    zs[i] = float(z * scale);
  }
  for (int i = 0; i < count; ++i) {
    out[3 * i] = xs[i];
    out[3 * i + 1] = ys[i];
    out[3 * i + 2] = zs[i];
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
      for (int x = 0; x < columns; x += kRun)
        normalRun(heights - stride + x, heights + x, heights + stride + x, std::min(kRun, columns - x),
                  2 * spacing, &normals[x].x);
      continue;
    }
    for (int x = 0; x < columns; ++x)
      normals[x] = teSampleNormal(heights[x], heights[x - 1], heights[x + 1], heights[x - stride],
                                  heights[x + stride], spacing);
  }
}
