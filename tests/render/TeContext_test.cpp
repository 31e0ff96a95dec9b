#include "render/TeRenderTest.h"

#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include "nodes/TeNodePtr.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace {

class TeContextTest : public TeRenderTest {};

/// A square [-0.5, 0.5]² of one colour, unlit, under a camera that shows [-1, 1]².
TeNodePtr<SoSeparator> square(const SbColor& colour, float transparency = 0) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* camera = new SoOrthographicCamera;
  camera->position.setValue(0, 0, 5);
  camera->height = 2;
  root->addChild(camera);
  auto* light = new SoLightModel;
  light->model = SoLightModel::BASE_COLOR;
  root->addChild(light);
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(colour);
  material->transparency = transparency;
  root->addChild(material);
  const SbVec3f corners[] = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  auto* coordinates = new SoCoordinate3;
  coordinates->point.setValues(0, 4, corners);
  root->addChild(coordinates);
  auto* faces = new SoIndexedFaceSet;
  const std::int32_t indices[] = {0, 1, 2, 3, -1};
  faces->coordIndex.setValues(0, 5, indices);
  root->addChild(faces);
  return root;
}

} // namespace

TEST_F(TeContextTest, TellsWhoDraws) {
  std::printf("%s: %s, OpenGL %s\n", context().name(), context().renderer().c_str(),
              context().version().c_str());
  EXPECT_FALSE(context().renderer().empty());
  EXPECT_FALSE(context().version().empty());
}

// A context that was not asked for must not be there: its OpenGL would be in the way.
TEST_F(TeContextTest, OtherContextsAreNotLoaded) {
  std::ifstream file("/proc/self/maps");
  const std::string maps((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  ASSERT_FALSE(maps.empty());
  const auto isLoaded = [&](const char* library) { return maps.find(library) != std::string::npos; };
  EXPECT_EQ(isLoaded("libOSMesa"), TeRenderTest::s_kind == TeContextKind::OsMesa);
  EXPECT_EQ(isLoaded("osmesa-shim"), TeRenderTest::s_kind == TeContextKind::OsMesa);
  EXPECT_EQ(isLoaded("libSoQt"), TeRenderTest::s_kind == TeContextKind::Window);
  EXPECT_EQ(isLoaded("context-egl"), TeRenderTest::s_kind == TeContextKind::Egl);
}

TEST_F(TeContextTest, DrawsWhatTheSceneSays) {
  const TePicture picture = draw(square(SbColor(0, 1, 0)).get(), 64, 48, "square");
  ASSERT_EQ(picture.rgba.size(), 64u * 48 * 4);
  EXPECT_EQ(picture.pixel(32, 24), (TePicture::Pixel{0, 255, 0, 255}));
  EXPECT_EQ(picture.pixel(1, 1), (TePicture::Pixel{255, 0, 255, 255}));
}

TEST_F(TeContextTest, TransparencyBlendsWithTheBackground) {
  const TePicture picture =
      draw(square(SbColor(0, 0, 1), 0.5f).get(), 64, 64, "transparent", SbColor(1, 0, 0));
  ASSERT_FALSE(picture.rgba.empty());
  EXPECT_NEAR(picture.pixel(32, 32)[0], 128, 2);
  EXPECT_NEAR(picture.pixel(32, 32)[2], 128, 2);
}

TEST_F(TeContextTest, SamplesSmoothEdges) {
  auto renderer = TeSceneRenderer::create(context(), 63, 63, 4);
  ASSERT_TRUE(renderer) << renderer.error().message;
  (*renderer)->setBackground(SbColor(0, 0, 0));
  auto scene = square(SbColor(1, 1, 1));
  const TeResult<TePicture> picture = (*renderer)->render(scene.get());
  ASSERT_TRUE(picture) << picture.error().message;
  int between = 0;
  for (int x = 0; x < 63; x++) {
    const int value = picture->pixel(x, 31)[0];
    between += value > 0 && value < 255;
  }
  EXPECT_GE(between, 1);
  EXPECT_EQ(picture->pixel(31, 31)[0], 255);
}

TEST_F(TeContextTest, TwoContextsTakeTurns) {
  auto other = TeContext::create(TeRenderTest::s_kind, 32, 32);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_NE((*other)->id(), context().id());
  const auto scene = square(SbColor(0, 1, 0));
  const TePicture before = draw(scene.get(), 64, 64, "turns");
  auto renderer = TeSceneRenderer::create(**other, 64, 64);
  ASSERT_TRUE(renderer) << renderer.error().message;
  (*renderer)->setBackground(SbColor(1, 0, 1));
  const TeResult<TePicture> between = (*renderer)->render(scene.get());
  ASSERT_TRUE(between) << between.error().message;
  EXPECT_EQ(before, *between);
  renderer->reset();
  other->reset();
  EXPECT_EQ(before, draw(scene.get(), 64, 64, "turns"));
}

TEST_F(TeContextTest, EndsByTellingCoin) {
  static std::uint32_t destroyed;
  destroyed = 0;
  const auto remember = [](std::uint32_t id, void*) { destroyed = id; };
  SoContextHandler::addContextDestructionCallback(remember, nullptr);
  auto other = TeContext::create(TeRenderTest::s_kind, 32, 32);
  ASSERT_TRUE(other) << other.error().message;
  const std::uint32_t id = (*other)->id();
  other->reset();
  SoContextHandler::removeContextDestructionCallback(remember, nullptr);
  EXPECT_EQ(destroyed, id);
}

TEST_F(TeContextTest, RefusesSizesOutOfRange) {
  for (const int side : {0, -1, TePicture::kMaxSide + 1}) {
    EXPECT_FALSE(TeContext::create(TeRenderTest::s_kind, side, 8));
    EXPECT_FALSE(TeSceneRenderer::create(context(), 8, side));
  }
  EXPECT_FALSE(TeSceneRenderer::create(context(), 8, 8, 0));
}

TEST_F(TeContextTest, SceneWithoutCameraIsAnError) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  root->addChild(new SoCube);
  auto renderer = TeSceneRenderer::create(context(), 16, 16);
  ASSERT_TRUE(renderer) << renderer.error().message;
  const TeResult<TePicture> picture = (*renderer)->render(root.get());
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().message.find("camera"), std::string::npos);
}
