#include "nodes/seamless/hillsNode.h"

#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

constexpr int kResolution = 128;
constexpr float kSide = 512; // samples 4 m apart

/// The same seen from the west as from the east, and from the south as from the north.
std::shared_ptr<const TeHeightMap> symmetricHills() {
  TeHeightMap map = std::move(TeHeightMap::create(kResolution + 1, kResolution + 1).value());
  for (int y = 0; y <= kResolution; y++) {
    for (int x = 0; x <= kResolution; x++)
      map.at(x, y) =
          float(20 * std::cos(0.2 * (x - kResolution / 2)) * std::cos(0.3 * (y - kResolution / 2)));
  }
  return std::make_shared<const TeHeightMap>(std::move(map));
}

using Vertex = std::array<float, 3>;

/// All corners of all triangles, sorted; mirrored back where signs are -1.
std::vector<Vertex> corners(SoNode* scene, float signX, float signY) {
  struct Result {
    std::vector<Vertex> corners;
    float x, y;
  } result{{}, signX, signY};
  SoCallbackAction action(SbViewportRegion(640, 480));
  action.addTriangleCallback(
      SoTeSeamlessPatches::getClassTypeId(),
      [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        auto& result = *static_cast<Result*>(data);
        for (const SoPrimitiveVertex* vertex : {a, b, c}) {
          const SbVec3f& point = vertex->getPoint();
          result.corners.push_back({point[0] * result.x + 0.0f, point[1] * result.y + 0.0f, point[2]});
        }
      },
      &result);
  action.apply(scene);
  std::sort(result.corners.begin(), result.corners.end());
  return result.corners;
}

bool areFinite(const std::vector<Vertex>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(),
                     [](const Vertex& vertex) { return std::isfinite(vertex[0] + vertex[1] + vertex[2]); });
}

} // namespace

// The camera on corners and edges of patches, on samples and in the surface, a bit beside them, below,
// looking straight down: all vertices are finite, and mirrored cameras see mirrored triangles.
TEST(HardCase, CameraOnCornerSeamless) {
  TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
  node->size.setValue(kSide, kSide, 0);
  node->resolution = kResolution;
  node->minPatchResolution = 4;
  node->precision = 1.5f;
  node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  const std::shared_ptr<const TeHeightMap> map = symmetricHills();
  node->setHeights(map);
  int views = 0, triangles = 0;
  for (const float pixelError : {0.0f, 8.0f}) {
    node->pixelError = pixelError;
    for (const glm::ivec2 sample :
         {glm::ivec2(64, 64), glm::ivec2(96, 64), glm::ivec2(65, 67), glm::ivec2(128, 128)}) {
      const float x = float(sample.x - 64) * 4, y = float(sample.y - 64) * 4;
      const float ground = map->at(sample.x, sample.y);
      for (const int ulp : {-1, 0, 1}) {
        const auto beside = [&](float value) {
          return ulp == 0 ? value : std::nextafter(value, float(ulp) * 1e9f);
        };
        for (const float height : {beside(ground), ground - 5, ground + 2}) {
          const SbVec3f eye(beside(x), beside(y), height);
          // Down, and along the ground, which is seen from both sides.
          for (const SbVec3f& ahead : {SbVec3f(0, 1e-4f, -1), SbVec3f(0.3f, 1, -0.1f)}) {
            std::vector<Vertex> wanted;
            for (const auto& [signX, signY] : {std::pair(1, 1), std::pair(-1, 1), std::pair(1, -1)}) {
              const SbVec3f mirror(float(signX), float(signY), 1);
              const auto scene = seenBy(SbVec3f(0, 0, 0), SbVec3f(0, 1, 0), node.get());
              auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
              camera->position.setValue(eye[0] * mirror[0], eye[1] * mirror[1], eye[2]);
              camera->heightAngle = 3.1f; // nearly all; what is in view does not depend on rounding
              camera->nearDistance = 1e-3f;
              camera->pointAt(camera->position.getValue() +
                                  SbVec3f(ahead[0] * mirror[0], ahead[1] * mirror[1], ahead[2]),
                              SbVec3f(0, 0, 1));
              const std::vector<Vertex> seen = corners(scene.get(), mirror[0], mirror[1]);
              EXPECT_TRUE(areFinite(seen));
              views++;
              triangles += int(seen.size() / 3);
              if (signX == 1 && signY == 1)
                wanted = seen;
              else
                EXPECT_EQ(seen, wanted) << eye[0] << " " << eye[1] << " " << eye[2];
            }
          }
        }
      }
    }
  }
  EXPECT_GT(triangles, 100000);
  std::printf("%d cameras on and around corners: %d triangles, all finite, mirrored alike\n", views,
              triangles);
}
