#include "nodes/context/TeWindow.h"

#include "nodes/TeNodePtr.h"
#include "render/TeRenderTest.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/sensors/SoTimerSensor.h>

namespace {

/// A square that fills half of the picture's height.
TeNodePtr<SoSeparator> square() {
  const TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoOrthographicCamera;
  camera->position.setValue(0, 0, 5);
  camera->nearDistance = 1;
  camera->farDistance = 10;
  camera->height = 4;
  scene->addChild(camera);
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  scene->addChild(unlit);
  auto* colour = new SoBaseColor;
  colour->rgb = SbColor(0, 1, 0);
  scene->addChild(colour);
  scene->addChild(new SoCube);
  return scene;
}

class Client : public TeWindowClient {
public:
  void opened(TeWindow& window) override { m_window = &window; }
  void resized(int newWidth, int newHeight) override {
    width = newWidth;
    height = newHeight;
  }
  void drawn(double, double drawSeconds, double finishSeconds) override {
    EXPECT_GE(finishSeconds, 0);
    finished += finishSeconds > 0;
    ++frames;
    seconds += drawSeconds;
  }
  TeWindow& window() { return *m_window; }

  int width = 0;
  int height = 0;
  int frames = 0;
  int finished = 0; ///< frames of which it is known when OpenGL was done
  double seconds = 0;

private:
  TeWindow* m_window = nullptr;
};

class TeWindowTest : public TeRenderTest {
protected:
  void SetUp() override {
    if (TeRenderTest::s_kind != TeContextKind::Window)
      GTEST_SKIP() << "only with --context window";
    TeRenderTest::SetUp();
  }
};

TEST_F(TeWindowTest, ShowsTheSceneWithItsOwnCamera) {
  Client client;
  TeViewerOptions options;
  options.width = 200;
  options.height = 100;
  options.background = SbColor(1, 0, 1);
  options.frames = 3;
  const TeResult<TeViewerSession> session = teRunWindow(square().get(), options, client);
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_EQ(session->frames, 3);
  EXPECT_GE(client.frames, 3);
  EXPECT_GT(client.seconds, 0);
  EXPECT_EQ(client.width, 200);
  EXPECT_EQ(client.height, 100);
  const TePicture& picture = session->picture;
  ASSERT_EQ(picture.width, 200);
  ASSERT_EQ(picture.height, 100);
  EXPECT_EQ(picture.pixel(100, 50), (TePicture::Pixel{0, 255, 0, 255}));
  EXPECT_EQ(picture.pixel(100, 10), (TePicture::Pixel{255, 0, 255, 255}));
  EXPECT_EQ(picture.pixel(60, 50), (TePicture::Pixel{255, 0, 255, 255}));
}

/// What happens to a window, by steps of half a second.
struct Visit {
  Client client;
  TeNodePtr<SoSeparator> scene = square();
  int step = 0;
  int settled = 0; ///< frames before the rest
  int rested = 0;  ///< after it
  int changed = 0; ///< after a change of the scene
  TePicture captured;

  static void next(void* data, SoSensor*) { static_cast<Visit*>(data)->next(); }
  void next() {
    switch (++step) {
    case 4:
      settled = client.frames;
      break;
    case 6:
      rested = client.frames;
      scene->touch();
      break;
    case 7:
      changed = client.frames;
      client.window().capture([this](const TeResult<TePicture>& picture) {
        ASSERT_TRUE(picture) << picture.error().message;
        captured = *picture;
      });
      break;
    case 8:
      client.window().close();
      break;
    }
  }
};

TEST_F(TeWindowTest, DrawsWhenTheSceneChangesAndElseNot) {
  Visit visit;
  SoTimerSensor steps(Visit::next, &visit);
  steps.setInterval(0.5);
  steps.schedule();
  TeViewerOptions options;
  options.width = options.height = 64;
  const TeResult<TeViewerSession> session = teRunWindow(visit.scene.get(), options, visit.client);
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_GT(visit.settled, 0);
  EXPECT_EQ(visit.rested, visit.settled);
  EXPECT_EQ(visit.changed, visit.rested + 1);
  ASSERT_EQ(visit.captured.width, 64);
  EXPECT_EQ(visit.captured.pixel(32, 32), (TePicture::Pixel{0, 255, 0, 255}));
}

} // namespace
