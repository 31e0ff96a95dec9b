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

inline double atLeastZero(double a) { return a > 0 ? a : 0; }
inline double larger(double a, double b) { return a > b ? a : b; }
inline double smaller(double a, double b) { return a < b ? a : b; }

TE_TARGET_CLONES
void prioritiesOf(const TeRoamScreen::Numbers& view, const float* x, const float* y, const float* size,
                  const float* low, const float* high, const float* error, std::size_t count, float* result) {
  const TeRoamScreen::Numbers v = view;
  for (std::size_t i = 0; i < count; i++) {
    const double west = double(x[i]), south = double(y[i]), side = double(size[i]);
    const double bottom = double(low[i]), top = double(high[i]);
    double inside = 0;
    for (int p = 0; p < 6; p++) {
      const TeRoamScreen::Plane& plane = v.planes[p];
      inside = smaller(inside, plane.x * (west + plane.east * side) + plane.y * (south + plane.north * side) +
                                   plane.low * bottom + plane.high * top + plane.w);
    }
    const double dx = atLeastZero(larger(west - v.eye[0], v.eye[0] - (west + side))) * v.scale[0];
    const double dy = atLeastZero(larger(south - v.eye[1], v.eye[1] - (south + side))) * v.scale[1];
    const double dz = atLeastZero(larger(bottom - v.eye[2], v.eye[2] - top)) * v.scale[2];
    const double distance = larger(std::sqrt(dx * dx + dy * dy + dz * dz) - v.slack, kNearest);
    const double divisor = v.perspective * distance + (1 - v.perspective);
    const double deviation = double(error[i]);
    const double pixels = smaller(deviation * v.focal * kUp / divisor, kLargest);
    const bool isSeen = inside >= 0 && deviation >= 0;
    result[i] = float(isSeen ? larger(pixels, v.least) : -1.0);
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
  for (int i = 0; i < 6; i++) {
    if (i >= view.planeCount)
      break; // the rest hold everything
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
