#pragma once

#include "nodes/SceneChanges.h"
#include "nodes/seamless/hillsNode.h"
#include "render/TeRenderTest.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/sensors/SoSensorManager.h>

#include <memory>
#include <string>
#include <utility>

/// Draws scenes with a SoTeSeamlessPatches in them.
class TeSeamlessNodeTest : public TeRenderTest {
protected:
  /// Draws with the camera's own near and far, before magenta.
  TePicture show(SoNode* scene, const std::string& name = "", int width = 320, int height = 240) {
    auto renderer = TeSceneRenderer::create(context(), width, height);
    EXPECT_TRUE(renderer);
    return frame(**renderer, scene, name);
  }
  static TePicture frame(TeSceneRenderer& renderer, SoNode* scene, const std::string& name = "") {
    renderer.setBackground(SbColor(1, 0, 1));
    renderer.setFitClipPlanes(false);
    TeResult<TePicture> picture = renderer.render(scene);
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    if (picture && !s_folder.empty() && !name.empty()) {
      EXPECT_TRUE(picture->writePng(s_folder + "/seamless-node-" + name + ".png"));
    }
    return picture ? std::move(*picture) : TePicture();
  }
  /// Draws until nothing asks for another frame; how many frames that took.
  int settle(SoNode* scene, TePicture& picture) {
    SceneChanges changes(scene);
    for (int frames = 1; frames < 1000; frames++) {
      changes.count = 0;
      picture = show(scene);
      SoDB::getSensorManager()->processDelayQueue(TRUE);
      if (changes.count == 0)
        return frames;
    }
    ADD_FAILURE() << "it never rests";
    return 0;
  }

  static void addSun(SoSeparator* scene) {
    auto* sun = new SoDirectionalLight;
    sun->direction.setValue(-0.4f, 0.7f, -0.7f);
    scene->insertChild(sun, 1);
  }
  static TeNodePtr<SoSeparator> overview(SoNode* node) {
    auto scene = seenBy(SbVec3f(-700, -800, 500), SbVec3f(0, 0, 80), node);
    addSun(scene.get());
    return scene;
  }
};

/// Hard cases that are drawn.
class HardCase : public TeSeamlessNodeTest {};
