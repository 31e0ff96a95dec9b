#include "render/TeSeamlessNodeTest.h"

#include <Inventor/nodes/SoOrthographicCamera.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr int kBudget = 100;

} // namespace

// Fields of view from 0.001° to 179°, orthographic views of any size, viewports down to one pixel: the
// patches drawn stay within their budget, and there is a picture.
TEST_F(HardCase, ExtremeViewsSeamless) {
  const auto node = hillsNode(1024);
  node->maxPatches = kBudget;
  std::int64_t most = 0;
  int views = 0;
  double slowest = 0;
  const auto draw = [&](SoSeparator* scene, int width, int height) {
    const TePicture picture = show(scene, "", width, height);
    EXPECT_EQ(picture.width, width);
    EXPECT_LE(node->statistics().rendered, kBudget);
    EXPECT_TRUE(std::isfinite(node->statistics().precision));
    EXPECT_FALSE(std::isnan(node->statistics().errorBound));
    EXPECT_GE(node->statistics().coarsening, 1);
    most = std::max(most, node->statistics().rendered);
    slowest = std::max(slowest, node->statistics().selectionSeconds);
    views++;
  };
  const std::pair<int, int> sizes[] = {{1, 1}, {1, 64}, {64, 1}, {64, 48}};
  for (const float precision : {1.0f, 1e6f}) {
    for (const float pixelError : {0.0f, 0.01f}) {
      node->precision = precision;
      node->pixelError = pixelError;
      for (const auto& [width, height] : sizes) {
        for (const double degrees : {0.001, 0.1, 1.0, 60.0, 150.0, 179.0}) {
          const auto scene = seenBy(SbVec3f(-100, -450, 180), SbVec3f(0, 0, 100), node.get());
          auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
          camera->heightAngle = float(degrees * M_PI / 180);
          draw(scene.get(), width, height);
        }
        for (const float size : {1e-3f, 1.0f, 500.0f, 1e6f}) {
          TeNodePtr<SoSeparator> scene(new SoSeparator);
          auto* camera = new SoOrthographicCamera;
          camera->position.setValue(3, 4, 1000);
          camera->height = size;
          camera->farDistance = 3000;
          scene->addChild(camera);
          scene->addChild(node.get());
          draw(scene.get(), width, height);
        }
      }
    }
  }
  std::printf("%d extreme views: at most %lld patches of a budget of %d, selection up to %.2f ms\n", views,
              static_cast<long long>(most), kBudget, 1000 * slowest);
}
