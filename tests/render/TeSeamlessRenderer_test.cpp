#include "nodes/seamless/TeSeamlessRenderer.h"

#include "render/TeGlNeighbour.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"
#include "render/seamlessScene.h"

#include <cstdio>

namespace {

class TeSeamlessRendererTest : public TeRenderTest {
protected:
  /// Before the scene: the drawing is freed in its context.
  std::unique_ptr<SeamlessScene> hills(TeSeamlessTechnique::Colours colours = TeSeamlessTechnique::Slope) {
    const TeSeamlessLayout layout = seamlessLayout(128, 4, 3);
    auto scene = std::make_unique<SeamlessScene>(layout, 1);
    scene->look.technique = {TeSeamlessTechnique::Heightmap, colours, true};
    scene->look.heights = hillyMap(128, 12);
    scene->look.slopes = TeSeamlessSlopeColours::forHeights(-14, 14);
    return scene;
  }
  /// Seen from one side and above; `before` stands before the terrain.
  TePicture show(SeamlessScene& scene, const std::string& name = "",
                 const std::vector<SoNode*>& before = {}) {
    const TePicture picture = showNode(scene.node.get(), name, before);
    EXPECT_EQ(scene.error, "");
    return picture;
  }
  TePicture showNode(SoNode* node, const std::string& name = "", const std::vector<SoNode*>& before = {}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    for (SoNode* other : before)
      group->addChild(other);
    group->addChild(node);
    const auto scene = sideView(group.get(), 130);
    auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
    camera->nearDistance = 1;
    camera->farDistance = 1000;
    auto renderer = TeSceneRenderer::create(context(), 320, 240);
    EXPECT_TRUE(renderer);
    (*renderer)->setBackground(SbColor(1, 0, 1));
    (*renderer)->setFitClipPlanes(false);
    TeResult<TePicture> picture = (*renderer)->render(scene.get());
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    if (!s_folder.empty() && !name.empty()) {
      EXPECT_TRUE(picture->writePng(s_folder + "/" + name + ".png"));
    }
    return std::move(*picture);
  }
};

} // namespace

TEST_F(TeSeamlessRendererTest, DrawsAHeightMapWithoutHoles) {
  const auto scene = hills();
  scene->select(selectLevel(scene->layout, 1, variedDetail(scene->layout, true)));
  const TePicture picture = show(*scene, "seamless-hills");
  EXPECT_GT(320 * 240 - countMagenta(picture), 10000);
  EXPECT_EQ(enclosedBackground(picture), 0);
  EXPECT_GT(scene->counts.triangles, 1000);
}
