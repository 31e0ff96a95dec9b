// The part of docs/writing-an-application.md about endless terrain, compiled and run.

#include "engine/TeEngine.h"
#include "engine/camera/TeCameraRig.h"
#include "engine/jobs/TeJob.h"
#include "engine/objects/TeAircraft.h"
#include "nodes/TeNodes.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace {

//! [aircraft]
std::unique_ptr<TeObject> aircraft(const char* name, glm::dvec3 position, glm::dvec3 velocity) {
  auto made = std::make_unique<TeAircraft>(name);
  const bool placed = made->setPosition(position) && made->setVelocity(velocity);
  return placed ? std::move(made) : nullptr;
}
//! [aircraft]

TEST(EndlessTerrain, AnApplication) {
  //! [scene]
  TeNodes::init(); // SoDB::init() and our own node classes

  SoSeparator* scene = new SoSeparator; // camera, lights, fog, and what else belongs to the world
  scene->ref();
  SoPerspectiveCamera* camera = new SoPerspectiveCamera;
  scene->addChild(camera);
  scene->addChild(new SoDirectionalLight);

  SoSeparator* hud = new SoSeparator; // drawn after the scene
  hud->ref();
  SoOrthographicCamera* hudCamera = new SoOrthographicCamera;
  hud->addChild(hudCamera);
  //! [scene]

  //! [engine]
  TeEngine* engine = new TeEngine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
  engine->setSeed(7);
  engine->setSceneRoot(scene);
  engine->setSceneCamera(camera);
  engine->setHudRoot(hud);
  engine->setHudCamera(hudCamera);

  // The user's aircraft, and another one to its left that flies north.
  TeObject* mine = engine->addObject(aircraft("mine", {0, 0, 60}, {0, 0, 0}));
  TeObject* other = engine->addObject(aircraft("other", {-60, 0, 60}, {0, 20, 0}));
  engine->setActiveObject(mine);

  if (!engine->initialize())
    std::fprintf(stderr, "%s\n", engine->lastError().c_str());
  //! [engine]
  ASSERT_TRUE(engine->isInitialized());

  //! [callbacks]
  int patches = 0;
  engine->setPatchReadyCallback([&](const TePatchKey&, SoGroup*) { ++patches; });
  engine->setPatchDroppedCallback([&](const TePatchKey&, SoGroup*) { --patches; });
  engine->setErrorCallback([](const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); });
  //! [callbacks]

  //! [keys]
  TeKeyEvent up;
  up.key = SoKeyboardEvent::UP_ARROW;
  up.down = true;
  engine->postKey(up); // faster, until the key is released
  //! [keys]

  double seconds = 0;
  const auto running = [&] { return seconds < 10; };
  const auto drawFrame = [&] { seconds += 1.0 / 30; };
  const double dt = 1.0 / 30;
  //! [loop]
  while (running()) {
    engine->timeTick(dt); // seconds since the last one
    if (engine->needsRedraw())
      drawFrame(); // the scene, then the HUD
  }
  //! [loop]
  EXPECT_GT(mine->position().y, 500);
  EXPECT_GE(patches, 9);
  EXPECT_NEAR(other->position().y, 200, 1);
  EXPECT_EQ(engine->getStatistics().framesWithoutGround, 0);

  //! [queries]
  const TeStatistics& statistics = engine->getStatistics();
  std::printf("%.1f m above ground, %lld patches drawn, worst tick %.1f ms\n", statistics.heightAboveGround,
              (long long)statistics.patches.drawn, 1000 * statistics.worstTickSeconds);
  //! [queries]
  EXPECT_GT(statistics.heightAboveGround, 0);

  //! [end]
  delete engine; // in any state; it takes its nodes out of the scene
  hud->unref();
  scene->unref();
  //! [end]
}

//! [job]
/// Counts trees, a thousand at a time.
class CountTrees final : public TeJob {
public:
  CountTrees() : TeJob(TeJobKind::Other, {}) {}

  TeProgress step(TeAllowance& allowance) override {
    do {
      m_trees += 1000;
    } while (m_trees < kForest && allowance.spend());
    return m_trees < kForest ? TeProgress::Working : TeProgress::Done;
  }
  TeJobState state() const override { return m_trees == 0 ? TeJobState::Waiting : TeJobState::Arrays; }
  const TeError& error() const override { return m_error; }

private:
  static constexpr int kForest = 1'000'000;
  int m_trees = 0;
  TeError m_error;
};
//! [job]

TEST(EndlessTerrain, AJobOfTheProgram) {
  TeNodes::init();
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoPerspectiveCamera;
  scene->addChild(camera);
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  engine.setSceneRoot(scene.get());
  engine.setSceneCamera(camera);
  engine.setActiveObject(engine.addObject(std::make_unique<TeAircraft>("mine")));
  ASSERT_TRUE(engine.initialize()) << engine.lastError();
  engine.addJob(std::make_unique<CountTrees>());
  EXPECT_FALSE(engine.isIdle());
  engine.finishJobs();
  EXPECT_EQ(engine.getStatistics().jobs.finished[std::size_t(TeJobKind::Other)], 1);
}

} // namespace
