#include "nodes/lod/LodTest.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdio>
#include <vector>

namespace {

constexpr int kCells = 64;

/// Alike on both sides of the diagonal along which cells are split.
TeHeightMap mirroredHills() {
  TeHeightMap map = TeHeightMap::create(kCells + 1, kCells + 1).value();
  for (int y = 0; y <= kCells; y++)
    for (int x = 0; x <= kCells; x++)
      map.at(x, y) =
          float(20 * std::cos(0.2 * x) * std::cos(0.2 * y) + 3 * std::sin(0.7 * x) + 3 * std::sin(0.7 * y));
  return map;
}

TeLodView mirrored(TeLodView view) {
  std::swap(view.eye.x, view.eye.y);
  for (glm::dvec4& plane : view.planes)
    std::swap(plane.x, plane.y);
  return view;
}

using Corner = std::array<float, 3>;

/// Column, row and height of all corners of triangles, each once. (How they are joined to triangles may
/// depend on the order in which a method walks.)
std::vector<Corner> cornersOf(const TeLodMesh& mesh, bool mirror) {
  std::vector<Corner> corners;
  for (const std::uint32_t index : mesh.indices) {
    const TeLodVertex& vertex = mesh.vertices[index];
    const float column = float(vertex.column), row = float(vertex.row);
    corners.push_back({mirror ? row : column, mirror ? column : row, vertex.height});
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

} // namespace

// The camera on corners and edges of patches, on samples, on and below the surface, and the next numbers
// beside them, looking straight down and along the ground: all is finite, the bound holds, and a camera
// mirrored at the diagonal of the terrain, which is alike on both sides, gets the mirrored vertices.
LOD_TEST(HardCase, CameraOnCornerLod) {
  const TeLodFieldPtr field = lodField(mirroredHills());
  const std::unique_ptr<TeLodMethod> method = lodMethod(name, field), other = lodMethod(name, field);
  ASSERT_TRUE(method && other);
  LodFrame frame(field), otherFrame(field);
  int views = 0;
  std::int64_t triangles = 0;
  for (const glm::ivec2 sample : {glm::ivec2(32, 32), {48, 32}, {33, 37}, {64, 64}, {0, 0}, {64, 16}})
    for (const int ulp : {-1, 0, 1})
      for (const double above : {0.0, -5.0, 2.0})
        for (const glm::dvec3 ahead : {glm::dvec3(0, 0, -1), {0.3, 1, -0.1}, {0, 0, 0}}) {
          const auto beside = [&](double value) {
            return ulp == 0 ? value : std::nextafter(value, ulp * 1e9);
          };
          glm::dvec3 eye = field->position(field->vertex(sample.x, sample.y));
          for (int axis = 0; axis < 3; axis++)
            eye[axis] = beside(eye[axis]);
          eye.z += above;
          TeLodView view = viewFrom(eye);
          if (ahead != glm::dvec3(0))
            lookAlong(view, ahead, 1);
          TeLodAccuracy accuracy;
          accuracy.pixelError = 8;
          SCOPED_TRACE(testing::Message() << sample.x << " " << sample.y << ", " << ulp << " ulp, " << above
                                          << " m above, ahead " << ahead.x << " " << ahead.z);
          method->select(view, accuracy);
          frame.take(*method);
          for (const TeLodVertex& vertex : frame.mesh().vertices)
            ASSERT_TRUE(std::isfinite(vertex.height));
          frame.expectRight(view, accuracy);
          other->select(mirrored(view), accuracy);
          otherFrame.take(*other);
          ASSERT_EQ(cornersOf(frame.mesh(), false), cornersOf(otherFrame.mesh(), true));
          if (testing::Test::HasFatalFailure())
            return;
          views += 2;
          triangles += method->selection().triangles;
        }
  std::printf("%s: %d cameras on and around corners, %lld triangles: all finite, mirrored alike\n",
              name.c_str(), views, static_cast<long long>(triangles));
}
