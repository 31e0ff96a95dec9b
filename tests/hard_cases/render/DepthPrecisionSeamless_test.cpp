#include "render/TeSeamlessNodeTest.h"

#include "nodes/askScene.h"
#include "render/magenta.h"

#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr float kNear = 10;
constexpr float kFar = 30000;

TeNodePtr<SoTeSeamlessPatches> plain(const SbColor& colour) {
  TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
  node->size.setValue(20000, 20000, 0);
  node->resolution = 1024;
  node->tileColor = colour;
  node->stripColor = colour;
  return node;
}

} // namespace

// Two plains, one a little above the other, 10 km away: all pixels show the upper one, though the two are
// drawn with other resolutions. The gap is what 24 bits of depth resolve there: 2 · d² / (near · 2^24).
// And near and far need not follow what is loaded: the box does not.
TEST_F(HardCase, DepthPrecisionSeamless) {
  const double distance = 10000;
  const double gap = 2 * distance * distance / (double(kNear) * std::ldexp(1.0, 24));
  const auto lower = plain(SbColor(1, 0, 0));
  const auto upper = plain(SbColor(0, 0, 1));
  upper->minPatchResolution = 4;
  TeNodePtr<SoSeparator> both(new SoSeparator);
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  both->addChild(unlit);
  both->addChild(upper.get());
  auto* down = new SoTranslation;
  down->translation.setValue(0, 0, float(-gap));
  both->addChild(down);
  both->addChild(lower.get());
  // From above the rim down on the plain's middle, 10 km from it.
  const auto scene = seenBy(SbVec3f(0, -8000, 6000), SbVec3f(0, 0, 0), both.get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  camera->nearDistance = kNear;
  camera->farDistance = kFar;
  camera->heightAngle = 0.2f;
  const TePicture picture = show(scene.get(), "depth");
  int wrong = 0;
  for (int y = 0; y < picture.height; y++) {
    for (int x = 0; x < picture.width; x++)
      wrong += picture.pixel(x, y)[0] > picture.pixel(x, y)[2];
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(countMagenta(picture), 0);
  std::printf("gap %.2f m at %.0f m, near %g m, 24 bits: %d of %d pixels show the lower plain\n", gap,
              distance, double(kNear), wrong, picture.width * picture.height);

  const HillsPyramid pyramid(1024);
  const auto node = pyramid.node(129, 1000, 2000);
  const auto loading = overview(node.get());
  const SbBox3f before = boxOf(loading.get());
  show(loading.get());
  EXPECT_EQ(boxOf(loading.get()), before);
  TePicture settled;
  EXPECT_GT(settle(loading.get(), settled), 2);
  EXPECT_EQ(boxOf(loading.get()), before);
}
