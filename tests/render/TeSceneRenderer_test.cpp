#include "nodes/TeSceneRenderer.h"

#include "nodes/TeNodePtr.h"
#include "render/TeRenderTest.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

namespace {

class TeSceneRendererTest : public TeRenderTest {};

constexpr TePicture::Pixel kRed = {255, 0, 0, 255};
constexpr TePicture::Pixel kGreen = {0, 255, 0, 255};
constexpr TePicture::Pixel kBlack = {0, 0, 0, 255};

/// A cube of side `side` around a point, unlit.
void addCube(SoSeparator* root, const SbVec3f& centre, float side, const SbColor& colour) {
  auto* piece = new SoSeparator;
  auto* light = new SoLightModel;
  light->model = SoLightModel::BASE_COLOR;
  piece->addChild(light);
  auto* base = new SoBaseColor;
  base->rgb = colour;
  piece->addChild(base);
  auto* translation = new SoTranslation;
  translation->translation = centre;
  piece->addChild(translation);
  auto* cube = new SoCube;
  cube->width = cube->height = cube->depth = side;
  piece->addChild(cube);
  root->addChild(piece);
}

SoPerspectiveCamera* addCamera(SoSeparator* root, float nearest, float farthest) {
  auto* camera = new SoPerspectiveCamera;
  camera->position.setValue(0, 0, 10);
  camera->nearDistance = nearest;
  camera->farDistance = farthest;
  root->addChild(camera);
  return camera;
}

} // namespace

TEST_F(TeSceneRendererTest, FitsClipPlanesUnlessToldNotTo) {
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  SoPerspectiveCamera* camera = addCamera(scene.get(), 1, 5);
  addCube(scene.get(), SbVec3f(0, 0, 0), 4, SbColor(1, 0, 0)); // 8 away
  auto renderer = TeSceneRenderer::create(context(), 32, 32);
  ASSERT_TRUE(renderer) << renderer.error().message;
  (*renderer)->setBackground(SbColor(0, 0, 0));

  (*renderer)->setFitClipPlanes(false);
  EXPECT_EQ((*renderer)->render(scene.get())->pixel(16, 16), kBlack);
  EXPECT_EQ(camera->nearDistance.getValue(), 1);
  EXPECT_EQ(camera->farDistance.getValue(), 5);

  (*renderer)->setFitClipPlanes(true);
  EXPECT_EQ((*renderer)->render(scene.get())->pixel(16, 16), kRed);
  EXPECT_GT(camera->farDistance.getValue(), 12);
}

// The HUD has a camera of its own, after the scene, and nothing of the scene hides it.
TEST_F(TeSceneRendererTest, DrawsASceneAndThenAHudWithACameraOfItsOwn) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* scene = new SoSeparator;
  addCamera(scene, 0.5f, 1e6f);
  addCube(scene, SbVec3f(0, 0, 8), 2, SbColor(1, 0, 0)); // fills the view, near
  root->addChild(scene);
  auto* hud = new SoSeparator;
  auto* depth = new SoDepthBuffer;
  depth->test = FALSE;
  hud->addChild(depth);
  auto* camera = new SoOrthographicCamera;
  camera->position.setValue(32, 32, 10);
  camera->height = 64; // a unit is a pixel
  camera->nearDistance = 0;
  camera->farDistance = 20;
  hud->addChild(camera);
  addCube(hud, SbVec3f(8, 56, 0), 8, SbColor(0, 1, 0));
  root->addChild(hud);

  auto renderer = TeSceneRenderer::create(context(), 64, 64);
  ASSERT_TRUE(renderer) << renderer.error().message;
  (*renderer)->setFitClipPlanes(false);
  for (int frame = 0; frame < 3; frame++) { // caches settle
    const TeResult<TePicture> picture = (*renderer)->render(root.get());
    ASSERT_TRUE(picture) << picture.error().message;
    for (int y = 0; y < 64; y++) {
      for (int x = 0; x < 64; x++) {
        const bool isHud = x >= 4 && x < 12 && y >= 52 && y < 60;
        ASSERT_EQ(picture->pixel(x, y), isHud ? kGreen : kRed) << x << " " << y;
      }
    }
  }
}
