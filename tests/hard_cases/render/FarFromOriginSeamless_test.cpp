#include "render/TeSeamlessNodeTest.h"

#include "render/comparePixels.h"

#include <cmath>
#include <cstdio>

// Terrain and viewer moved together by 2^k metres, the node told of it by center and origin: the same bits in
// every pixel. Camera 2 m above the ground, so that a centimetre would be seen.
TEST_F(HardCase, FarFromOriginSeamless) {
  const HillsPyramid pyramid(512);
  TeNodePtr<SoTeSeamlessPatches> nodes[] = {hillsNode(512, 1024), pyramid.node(129, 1024)};
  int compared = 0, otherwise = 0;
  double farthest = 0;
  for (const auto& node : nodes) {
    const auto scene = seenBy(SbVec3f(-20, -300, 118), SbVec3f(100, 100, 80), node.get());
    static_cast<SoPerspectiveCamera*>(scene->getChild(0))->nearDistance = 0.1f;
    addSun(scene.get());
    TePicture wanted;
    settle(scene.get(), wanted);
    EXPECT_EQ(wanted.width, 320);
    for (int k = 10; k <= 40; k += 3) {
      const double far = std::ldexp(1.0, k);
      node->center.setValue(far, -far, far / 2);
      node->origin.setValue(far, -far, far / 2);
      TePicture picture;
      settle(scene.get(), picture);
      EXPECT_EQ(comparePixels(picture, wanted).pixels, 0) << "2^" << k;
      compared++;
      farthest = far;
    }
    // And with an origin of its own, from which the camera is seen elsewhere: Coin's matrices are single
    // precision, and round otherwise.
    node->center.setValue(1e9, 1e9, 0);
    node->origin.setValue(1e9 - 64, 1e9 - 128, 0);
    auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
    camera->position = camera->position.getValue() + SbVec3f(64, 128, 0);
    TePicture picture;
    settle(scene.get(), picture);
    otherwise = std::max(otherwise, comparePixels(picture, wanted).pixels);
  }
  EXPECT_LE(otherwise, 10);
  std::printf(
      "%d pictures up to %g m from the origin: not one pixel differs (from another local origin: %d)\n",
      compared, farthest, otherwise);
}
