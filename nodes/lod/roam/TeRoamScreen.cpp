#include "nodes/lod/roam/TeRoamScreen.h"

#include "patchdb/TeTargetClones.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double kRounding = 1e-14; ///< of coordinates, on the way from the world to here
constexpr double kUp = 1 + 1.5 / (1 << 23);
constexpr double kLargest = std::numeric_limits<float>::max();
constexpr double kNearest = 1e-300; ///< metres: no division by 0

constexpr std::size_t kBlock = 64; ///< triangles whose numbers stay in the nearest cache

inline double larger(double a, double b) { return a > b ? a : b; }
inline double smaller(double a, double b) { return a < b ? a : b; }

// Loops without branches over short arrays: all of them are vectorised.
TE_TARGET_CLONES
void prioritiesOf(const TeRoamScreen::Numbers& v, const float* x, const float* y, const float* size,
                  const float* low, const float* high, const float* error, std::size_t count, float* result) {
  double west[kBlock], south[kBlock], side[kBlock], bottom[kBlock], top[kBlock], inside[kBlock];
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t n = count - first < kBlock ? count - first : kBlock;
    for (std::size_t i = 0; i < n; i++) {
      west[i] = double(x[first + i]);
      south[i] = double(y[first + i]);
      side[i] = double(size[first + i]);
      bottom[i] = double(low[first + i]);
      top[i] = double(high[first + i]);
      inside[i] = double(error[first + i]); // negative: no triangle
    }
    for (int p = 0; p < v.planeCount; p++) {
      const TeRoamScreen::Plane plane = v.planes[p];
      for (std::size_t i = 0; i < n; i++)
        inside[i] = smaller(inside[i], plane.x * (west[i] + plane.east * side[i]) +
                                           plane.y * (south[i] + plane.north * side[i]) +
                                           plane.low * bottom[i] + plane.high * top[i] + plane.w);
    }
    const double eyeX = v.eye[0], eyeY = v.eye[1], eyeZ = v.eye[2];
    const double scaleX = v.scale[0], scaleY = v.scale[1], scaleZ = v.scale[2];
    const double slack = v.slack, focal = v.focal * kUp, least = v.least;
    const double perspective = v.perspective, orthographic = 1 - v.perspective;
    for (std::size_t i = 0; i < n; i++) {
      const double dx = larger(larger(west[i] - eyeX, eyeX - (west[i] + side[i])), 0) * scaleX;
      const double dy = larger(larger(south[i] - eyeY, eyeY - (south[i] + side[i])), 0) * scaleY;
      const double dz = larger(larger(bottom[i] - eyeZ, eyeZ - top[i]), 0) * scaleZ;
      const double distance = larger(std::sqrt(dx * dx + dy * dy + dz * dz) - slack, kNearest);
      const double divisor = perspective * distance + orthographic;
      const double pixels = larger(smaller(double(error[first + i]) * focal / divisor, kLargest), least);
      result[first + i] = float(inside[i] >= 0 ? pixels : -1.0);
    }
  }
}

} // namespace

TeRoamScreen::TeRoamScreen(const TeLodField& field, const TeLodView& view, float least) {
  const glm::dvec3 corner = field.placement().corner,
                   scale(field.spacing(), field.spacing(), field.heightScale());
  const glm::dvec3 eye = view.eye - corner;
  const double heights = std::max(std::fabs(double(field.lowest())), std::fabs(double(field.highest())));
  const double size = field.spacing() * field.cells() + field.heightScale() * heights;
  const auto reach = [](const glm::dvec3& point) {
    return std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  };
  const double rounding = kRounding * (reach(view.eye) + reach(corner) + size);
  for (int axis = 0; axis < 3; axis++) {
    m_numbers.scale[axis] = scale[axis];
    m_numbers.eye[axis] = scale[axis] > 0 ? eye[axis] / scale[axis] : 0;
  }
  // Heights pressed flat: the eye's distance to them does not depend on the height, and there is no error.
  m_numbers.slack = view.slack + rounding;
  m_numbers.focal = view.focal * scale.z;
  m_numbers.perspective = view.perspective ? 1 : 0;
  m_numbers.least = double(least);
  m_numbers.planeCount = view.planeCount;
  for (int i = 0; i < view.planeCount; i++) {
    const glm::dvec4& plane = view.planes[std::size_t(i)];
    Plane& made = m_numbers.planes[i];
    made.x = plane.x * scale.x;
    made.east = plane.x > 0 ? 1 : 0;
    made.y = plane.y * scale.y;
    made.north = plane.y > 0 ? 1 : 0;
    (plane.z > 0 ? made.high : made.low) = plane.z * scale.z;
    made.w = plane.w + glm::dot(glm::dvec3(plane), corner) + 4 * rounding;
  }
}

void TeRoamScreen::priorities(const TeRoamBoxes& boxes, std::size_t first, std::size_t count,
                              float* result) const {
  prioritiesOf(m_numbers, boxes.x.data() + first, boxes.y.data() + first, boxes.size.data() + first,
               boxes.low.data() + first, boxes.high.data() + first, boxes.error.data() + first, count,
               result);
}
