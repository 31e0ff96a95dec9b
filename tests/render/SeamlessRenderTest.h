#pragma once

#include "render/TeRenderTest.h"
#include "render/magenta.h"
#include "render/meshScene.h"
#include "render/seamlessScene.h"

#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>

#include <functional>

/// Shows a SeamlessScene.
class SeamlessRenderTest : public TeRenderTest {
protected:
  /// Before the scene: the drawing is freed in its context.
  std::unique_ptr<SeamlessScene> hills(TeSeamlessTechnique::Colours colours = TeSeamlessTechnique::Slope,
                                       bool wholePatches = false) {
    const TeSeamlessLayout layout = seamlessLayout(128, 4, 3);
    auto scene = std::make_unique<SeamlessScene>(layout, 1, wholePatches);
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
  /// The whole terrain in 240 × 240 pixels, north upward.
  TePicture showFromAbove(SeamlessScene& scene, const std::vector<SoNode*>& before = {}) {
    TeNodePtr<SoSeparator> root(new SoSeparator);
    auto* camera = new SoOrthographicCamera;
    camera->position.setValue(0, 0, 500);
    camera->height = float(scene.layout.resolution());
    camera->nearDistance = 1;
    camera->farDistance = 1000;
    root->addChild(camera);
    for (SoNode* other : before)
      root->addChild(other);
    root->addChild(scene.node.get());
    return render(context(), root.get(), 240, 240);
  }
  TePicture showNode(SoNode* node, const std::string& name = "", const std::vector<SoNode*>& before = {}) {
    const TePicture picture = renderIn(context(), node, before);
    if (!s_folder.empty() && !name.empty()) {
      EXPECT_TRUE(picture.writePng(s_folder + "/" + name + ".png"));
    }
    return picture;
  }
  TePicture renderIn(TeContext& context, SoNode* node, const std::vector<SoNode*>& before = {}) {
    const TeNodePtr<SoNode> held(node);
    TeNodePtr<SoSeparator> group(new SoSeparator);
    for (SoNode* other : before)
      group->addChild(other);
    group->addChild(node);
    const auto scene = sideView(group.get(), 130);
    auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
    camera->nearDistance = 1;
    camera->farDistance = 1000;
    return render(context, scene.get(), 320, 240);
  }
  static TePicture render(TeContext& context, SoNode* root, int width, int height) {
    auto renderer = TeSceneRenderer::create(context, width, height);
    EXPECT_TRUE(renderer);
    (*renderer)->setBackground(SbColor(1, 0, 1));
    (*renderer)->setFitClipPlanes(false);
    TeResult<TePicture> picture = (*renderer)->render(root);
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    return picture ? std::move(*picture) : TePicture();
  }
};

inline std::shared_ptr<const TePicture> picture(int side,
                                                const std::function<TePicture::Pixel(int, int)>& pixel) {
  TePicture made;
  made.width = made.height = side;
  for (int y = 0; y < side; y++)
    for (int x = 0; x < side; x++)
      for (const std::uint8_t channel : pixel(x, y))
        made.rgba.push_back(channel);
  return std::make_shared<const TePicture>(std::move(made));
}

inline std::shared_ptr<const TePicture> plainPicture(std::uint8_t red, std::uint8_t green,
                                                     std::uint8_t blue) {
  return picture(4, [=](int, int) { return TePicture::Pixel{red, green, blue, 255}; });
}

inline TeNodePtr<SoLightModel> unlit() {
  TeNodePtr<SoLightModel> model(new SoLightModel);
  model->model = SoLightModel::BASE_COLOR;
  return model;
}
