#include "engine/TeEngineRuntime.h"

#include "engine/objects/TeAircraft.h"
#include "generators/base/TeHash.h"
#include "tests/engine/TeEndlessWorld.h"

#include <gtest/gtest.h>

#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace {

constexpr double kDt = 1.0 / 30;

/// The groups of patches in the scene.
SoGroup* patchesOf(const TeEndlessWorld& world) {
  auto* terrain = static_cast<SoGroup*>(world.scene->getChild(world.scene->getNumChildren() - 2));
  return static_cast<SoGroup*>(terrain->getChild(terrain->getNumChildren() - 1));
}

int piecesOf(const TeEndlessWorld& world) {
  int pieces = 0;
  for (int i = 0; i < patchesOf(world)->getNumChildren(); ++i)
    pieces += static_cast<SoGroup*>(patchesOf(world)->getChild(i))->getNumChildren();
  return pieces;
}

TEST(TeEngineRuntime, WhatIsMissingIsAllSaidAtOnce) {
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64, 64));
  EXPECT_FALSE(engine.initialize());
  for (const char* what : {"scene root", "scene camera", "active object"})
    EXPECT_NE(engine.lastError().find(what), std::string::npos) << engine.lastError();
  EXPECT_FALSE(engine.timeTick(kDt));
  EXPECT_FALSE(engine.isInitialized());
}

TEST(TeEngineRuntime, ACameraOutsideTheSceneIsAnError) {
  TeEndlessWorld world;
  TeNodePtr<SoPerspectiveCamera> elsewhere(new SoPerspectiveCamera);
  ASSERT_TRUE(world.engine.setSceneCamera(elsewhere.get()));
  EXPECT_FALSE(world.engine.initialize());
  EXPECT_NE(world.engine.lastError().find("camera"), std::string::npos);
}

TEST(TeEngineRuntime, SettingsOutOfRangeAreErrorsAndChangeNothing) {
  TeEndlessWorld world;
  const double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double budget : {0.0, -1.0, 1.5, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(world.engine.setBudget(budget)) << budget;
  for (const double rate : {-1.0, 0.5, 1e6, kNaN})
    EXPECT_FALSE(world.engine.setFrameRate(rate)) << rate;
  EXPECT_FALSE(world.engine.setUnitBudget(-1));
  EXPECT_FALSE(world.engine.setRadius(0));
  EXPECT_FALSE(world.engine.setRadius(TeEngine::kMaxRadius + 1));
  EXPECT_FALSE(world.engine.setWorkers(-1));
  EXPECT_FALSE(world.engine.setActiveObject(nullptr));
  EXPECT_FALSE(world.engine.removeObject(nullptr));
  ASSERT_TRUE(world.engine.initialize()) << world.engine.lastError();
  EXPECT_DOUBLE_EQ(world.statistics().budgetSeconds, TeEngine::kDefaultBudget);
  for (const double dt : {-0.1, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(world.engine.timeTick(dt)) << dt;
  EXPECT_EQ(world.statistics().ticks, 0);
  EXPECT_FALSE(world.engine.setSceneRoot(world.scene.get())) << "too late";
  EXPECT_FALSE(world.engine.setWorkers(2)) << "too late";
  EXPECT_FALSE(world.engine.setSeed(3)) << "too late";
}

TEST(TeEngineRuntime, TheGroundIsKnownAtOnceAndTheBlockSoon) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize()) << world.engine.lastError();
  EXPECT_TRUE(world.engine.getDatabase()->heightAt({0, 0}));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(world.statistics().framesWithoutGround, 0);
  world.engine.finishJobs();
  EXPECT_EQ(world.statistics().patches.drawn, 9);
  EXPECT_EQ(world.statistics().patches.missing, 0);
  EXPECT_EQ(patchesOf(world)->getNumChildren(), 9);
  EXPECT_EQ(piecesOf(world), 9 + 12 + 4) << "insides, seams, corner squares";
}

TEST(TeEngineRuntime, AtTheStartTheGroundBelowEveryObjectIsKnown) {
  TeEndlessWorld world;
  world.engine.setUnitBudget(1);
  std::vector<double> places = {5e3, -7e4, 1e9};
  for (const double x : places)
    ASSERT_TRUE(world.engine.addObject(std::make_unique<TeProbe>("other"))->setPosition({x, x, 0}));
  ASSERT_TRUE(world.engine.initialize());
  for (const double x : places)
    EXPECT_TRUE(world.engine.getDatabase()->heightAt({x, x})) << x;
}

TEST(TeEngineRuntime, OnCrossingThePatchBelowBecomesTheMiddle) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  std::set<SoNode*> before;
  for (int i = 0; i < 9; ++i)
    before.insert(patchesOf(world)->getChild(i));

  ASSERT_TRUE(world.object->setPosition({world.side(), 0, 50}));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  world.engine.finishJobs();
  EXPECT_EQ(patchesOf(world)->getNumChildren(), 9);
  EXPECT_EQ(piecesOf(world), 25);
  int kept = 0;
  for (int i = 0; i < 9; ++i)
    kept += int(before.count(patchesOf(world)->getChild(i)));
  EXPECT_EQ(kept, 6) << "two columns of three stay";
}

TEST(TeEngineRuntime, FlyingStraightNothingInViewIsMissingOnceTheBlockIsComplete) {
  for (const double speed : {60.0, 600.0}) {
    TeEndlessWorld world(65, 64);
    world.engine.setUnitBudget(48);
    EXPECT_TRUE(world.object->setVelocity({0, speed, 0}));
    ASSERT_TRUE(world.engine.initialize());
    for (int i = 0; i < 300; ++i)
      ASSERT_TRUE(world.engine.timeTick(kDt));
    EXPECT_EQ(world.statistics().framesWithMissingLater, 0) << speed;
    EXPECT_EQ(world.statistics().framesWithoutGround, 0) << speed;
    EXPECT_LE(world.statistics().ticksUntilComplete, 30) << speed;
  }
}

TEST(TeEngineRuntime, ToAndFroOverAnEdgeNothingIsMadeAgain) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(world.object->setPosition({world.side() / 2 + (i % 2 ? 0.1 : -0.1), 0, 50}));
    ASSERT_TRUE(world.engine.timeTick(kDt));
  }
  world.engine.finishJobs();
  EXPECT_EQ(world.statistics().patches.madeAgain, 0);
  EXPECT_EQ(world.statistics().patches.dropped, 0);
}

TEST(TeEngineRuntime, EveryOtherObjectKeepsThePatchBelowIt) {
  TeEndlessWorld world;
  TeObject* other = world.engine.addObject(std::make_unique<TeProbe>("other"));
  ASSERT_TRUE(other->setPosition({1000 * world.side(), 0, 0}));
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  const TePatchDatabase& terrain = *world.engine.getDatabase();
  EXPECT_TRUE(terrain.heightAt({1000 * world.side(), 0}));
  EXPECT_FALSE(terrain.heightAt({1001 * world.side(), 0}));
  EXPECT_EQ(patchesOf(world)->getNumChildren(), 9) << "it is not drawn";

  ASSERT_TRUE(world.engine.removeObject(other));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  world.engine.finishJobs();
  EXPECT_FALSE(terrain.heightAt({1000 * world.side(), 0}));
}

TEST(TeEngineRuntime, AfterATeleportTheGroundIsThereSoonAndTheOldJobsAreGone) {
  TeEndlessWorld world;
  world.engine.setRadius(4);
  world.engine.setUnitBudget(4);
  ASSERT_TRUE(world.engine.initialize());
  ASSERT_TRUE(world.engine.timeTick(kDt));
  for (const double x : {1e6, -1e9, 0x1p33 * 32, 0.0}) {
    ASSERT_TRUE(world.object->setPosition({x, x, 50}));
    ASSERT_TRUE(world.engine.timeTick(kDt));
    std::int64_t waiting = 0;
    for (const auto& kind : world.statistics().jobs.now)
      for (const std::int64_t count : kind)
        waiting += count;
    EXPECT_LE(waiting, 81 + 81) << "only jobs of the new place, after one tick";
    int ticks = 1;
    while (!world.engine.getDatabase()->heightAt({x, x}) && ticks < 100) {
      ASSERT_TRUE(world.engine.timeTick(kDt));
      ++ticks;
    }
    EXPECT_LE(ticks, 8) << x;
  }
  world.engine.finishJobs();
  EXPECT_EQ(world.statistics().patches.drawn, 81);
}

TEST(TeEngineRuntime, WhatIsMadeDoesNotDependOnBudgetOrWorkers) {
  std::set<std::uint64_t> hashes;
  for (const int workers : {0, 1, 4}) {
    for (const int units : {3, 1000}) {
      TeEndlessWorld world;
      world.engine.setWorkers(workers);
      world.engine.setUnitBudget(units);
      world.engine.setRadius(2);
      ASSERT_TRUE(world.object->setVelocity({30, 50, 0}));
      ASSERT_TRUE(world.engine.initialize());
      for (int i = 0; i < 60; ++i)
        ASSERT_TRUE(world.engine.timeTick(kDt));
      world.engine.finishJobs();
      hashes.insert(world.engine.stateHash(true));
      EXPECT_EQ(world.statistics().patches.missing, 0);
    }
  }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST(TeEngineRuntime, WhatLowFlyersDoDoesNotDependOnBudgetOrWorkers) {
  std::set<std::uint64_t> hashes;
  for (const int workers : {0, 2})
    for (const int units : {12, 1000}) {
      TeEndlessWorld world(65, 64);
      world.engine.setWorkers(workers);
      world.engine.setUnitBudget(units);
      EXPECT_TRUE(world.object->setVelocity({-40, 40, 0}));
      TeObject* other = world.engine.addObject(std::make_unique<TeAircraft>("other"));
      EXPECT_TRUE(other->setPosition({-400, 0, -1000})) << "it is lifted to its clearance above the ground";
      EXPECT_TRUE(other->setVelocity({10, 60, 0}));
      ASSERT_TRUE(world.engine.initialize());
      std::uint64_t hash = 0;
      for (int i = 0; i < 150; ++i) {
        ASSERT_TRUE(world.engine.timeTick(kDt));
        hash = teHashCombine(hash, world.engine.stateHash());
      }
      EXPECT_GT(other->position().z, -100);
      hashes.insert(hash);
    }
  EXPECT_EQ(hashes.size(), 1u);
}

TEST(TeEngineRuntime, WithUnitsARunRepeatsTickByTick) {
  const auto run = [](int workers) {
    TeEndlessWorld world;
    world.engine.setWorkers(workers);
    world.engine.setUnitBudget(5);
    EXPECT_TRUE(world.object->setVelocity({0, 100, 0}));
    EXPECT_TRUE(world.engine.initialize());
    std::vector<std::int64_t> counts;
    for (int i = 0; i < 90; ++i) {
      EXPECT_TRUE(world.engine.timeTick(kDt));
      counts.push_back(world.statistics().patches.resident);
      counts.push_back(world.statistics().patches.drawn);
      counts.push_back(world.statistics().jobs.mapsMade);
    }
    return counts;
  };
  EXPECT_EQ(run(0), run(0));
  EXPECT_EQ(run(2), run(2)) << "however fast the workers are";
}

TEST(TeEngineRuntime, AnIdleEngineAsksForNothing) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  EXPECT_FALSE(world.engine.isIdle()) << "the block is still to be made";
  for (int i = 0; i < 1000 && !world.engine.isIdle(); ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_TRUE(world.engine.isIdle());
  world.engine.frameDrawn(kDt, 0.001);
  EXPECT_FALSE(world.engine.needsRedraw());
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_FALSE(world.engine.needsRedraw()) << "a tick without anything to do changes nothing";
  ASSERT_TRUE(world.object->setVelocity({1, 0, 0}));
  EXPECT_FALSE(world.engine.isIdle());
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_TRUE(world.engine.needsRedraw());
}

TEST(TeEngineRuntime, ProgramsAreToldOfPatchesAndMayAddToTheirGraphs) {
  TeEndlessWorld world;
  std::set<TePatchKey> known;
  world.engine.setPatchReadyCallback([&](const TePatchKey& key, SoGroup* graph) {
    EXPECT_TRUE(known.insert(key).second) << key.text();
    EXPECT_TRUE(world.engine.getDatabase()->find(key)->hasHeights());
    ASSERT_NE(graph, nullptr);
    graph->addChild(new SoSeparator);
  });
  world.engine.setPatchDroppedCallback(
      [&](const TePatchKey& key, SoGroup*) { EXPECT_EQ(known.erase(key), 1u); });
  EXPECT_TRUE(world.object->setVelocity({0, 200, 0}));
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 60; ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(std::int64_t(known.size()), world.statistics().patches.resident);
  EXPECT_GT(world.statistics().patches.dropped, 0);
}

TEST(TeEngineRuntime, CallBacksMayChangeTheEngine) {
  TeEndlessWorld world;
  int calls = 0;
  world.engine.setPatchReadyCallback([&](const TePatchKey&, SoGroup*) {
    if (++calls == 3) {
      EXPECT_TRUE(world.object->setPosition({1e5, 0, 50}));
    }
    if (calls == 5) {
      TeObject* other = world.engine.addObject(std::make_unique<TeProbe>("other"));
      world.engine.setActiveObject(other);
      world.engine.removeObject(world.object);
    }
  });
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 30; ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_GE(calls, 5);
}

/// Fails on one map.
class BrokenSource final : public TePointSource {
public:
  std::string name() const override { return "broken"; }
  std::uint64_t fingerprint() const override { return 1; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample*, std::size_t count,
                    float* heights) const override {
    if (request.key == TeMapKey{2, 2})
      return TeError{"this place is broken"};
    std::fill(heights, heights + count, 1.0f);
    return {};
  }
};
class BrokenGenerator final : public TeGenerator {
public:
  std::string name() const override { return "broken"; }
  TeParameters parameters() override { return {}; }

protected:
  void setDefaults() override {}
  TeResult<TeHeightSourcePtr> makeSource() const override {
    return TeHeightSourcePtr(std::make_shared<BrokenSource>());
  }
};

TEST(TeEngineRuntime, UnusableParametersAreReportedOnceAndTheWorldGoesOn) {
  class Sometimes final : public TeGenerator {
  public:
    explicit Sometimes(const bool& usable) : m_usable(usable) {}
    std::string name() const override { return "sometimes"; }
    TeParameters parameters() override { return {}; }

  protected:
    void setDefaults() override {}
    TeResult<TeHeightSourcePtr> makeSource() const override {
      if (!m_usable)
        return TeError{"sometimes: not now"};
      return TeHeightSourcePtr(std::make_shared<BrokenSource>());
    }

  private:
    const bool& m_usable;
  };
  bool usable = true;
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.setGenerator(std::make_unique<Sometimes>(usable)));
  std::vector<std::string> errors;
  world.engine.setErrorCallback([&](const std::string& message) { errors.push_back(message); });
  ASSERT_TRUE(world.object->setVelocity({0, -30, 0}));
  ASSERT_TRUE(world.engine.initialize());
  for (const bool now : {false, true, false}) {
    usable = now;
    for (int i = 0; i < 10; ++i)
      ASSERT_TRUE(world.engine.timeTick(0.1));
  }
  EXPECT_NEAR(world.object->position().y, -90, 1e-6);
  EXPECT_EQ(std::count(errors.begin(), errors.end(), "sometimes: not now"), 2);
}

TEST(TeEngineRuntime, APatchThatCannotBeMadeIsReportedAndTheRestIsThere) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.setGenerator(std::make_unique<BrokenGenerator>()));
  std::vector<std::string> errors;
  world.engine.setErrorCallback([&](const std::string& message) { errors.push_back(message); });
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 50; ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  ASSERT_EQ(errors.size(), 1u) << "once, not every tick";
  EXPECT_NE(errors[0].find("this place is broken"), std::string::npos);
  EXPECT_NE(errors[0].find("(1, 1)"), std::string::npos) << errors[0];
  EXPECT_EQ(world.statistics().patches.resident, 8);
  EXPECT_TRUE(world.engine.isIdle());
}

TEST(TeEngineRuntime, WhatCouldNotBeMadeIsTriedAgainAfterAWhile) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.setGenerator(std::make_unique<BrokenGenerator>()));
  int errors = 0;
  world.engine.setErrorCallback([&](const std::string&) { ++errors; });
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < int(5.5 * TeTerrain::kRetryTicks); ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(errors, 6) << "at the first tick, and at every retry since";
}

TEST(TeEngineRuntime, FlyingForLongMemoryStaysFlat) {
  TeEndlessWorld world;
  EXPECT_TRUE(world.object->setVelocity({0, 320, 0}));
  world.engine.setUnitBudget(200);
  ASSERT_TRUE(world.engine.initialize());
  const auto peak = [&world] {
    const TeStatistics::Memory& memory = world.statistics().peak;
    return memory.total() - memory.records;
  };
  std::size_t full = 0;
  for (int i = 0; i < 900; ++i) {
    ASSERT_TRUE(world.engine.timeTick(kDt));
    if (i == 200)
      full = peak();
  }
  EXPECT_EQ(peak(), full);
  EXPECT_EQ(world.statistics().framesWithoutGround, 0);
}

TEST(TeEngineRuntime, AnEngineThatCannotStartLeavesTheSceneAsItWasAndMayStartLater) {
  TeEndlessWorld world;
  const int children = world.scene->getNumChildren();
  ASSERT_TRUE(world.object->setPosition({1e300, 0, 50}));
  EXPECT_FALSE(world.engine.initialize());
  EXPECT_EQ(world.scene->getNumChildren(), children);
  ASSERT_TRUE(world.object->setPosition({0, 0, 50}));
  EXPECT_TRUE(world.engine.initialize()) << world.engine.lastError();
  world.scene->removeAllChildren(); // the engine's nodes, too
}

TEST(TeEngineRuntime, AnEngineThatGoesTakesItsNodesOutOfTheScene) {
  TeNodePtr<SoSeparator> scene;
  TeNodePtr<SoSeparator> hud;
  {
    TeEndlessWorld world;
    scene = world.scene;
    hud = TeNodePtr<SoSeparator>(new SoSeparator);
    world.engine.setHudRoot(hud.get());
    world.engine.setHudCamera(new SoOrthographicCamera);
    ASSERT_TRUE(world.engine.initialize());
    EXPECT_EQ(hud->getNumChildren(), 2);
    EXPECT_EQ(scene->getNumChildren(), 3);
  }
  EXPECT_EQ(hud->getNumChildren(), 1) << "the camera";
  EXPECT_EQ(scene->getNumChildren(), 1);
}

TEST(TeEngineRuntime, OutsideTheWorldTheSceneStaysFiniteAndTheWayBackIsOpen) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  const auto isFinite = [](const SbVec3f& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  const auto* camera = static_cast<SoPerspectiveCamera*>(world.scene->getChild(0));
  const auto* terrain = static_cast<SoGroup*>(world.scene->getChild(1));
  const auto* translation = static_cast<SoTranslation*>(terrain->getChild(0));
  for (const glm::dvec3& place : {glm::dvec3(1e300, 0, 50), {0, 0, 1e300}, {-1e30, 1e200, -1e300}}) {
    ASSERT_TRUE(world.object->setPosition(place));
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(world.engine.timeTick(kDt));
    EXPECT_TRUE(isFinite(camera->position.getValue())) << place.x;
    EXPECT_TRUE(std::isfinite(camera->farDistance.getValue())) << place.x;
    EXPECT_TRUE(isFinite(translation->translation.getValue())) << place.x;
    EXPECT_TRUE(world.engine.isIdle());
  }
  ASSERT_TRUE(world.object->setPosition({0, 0, 50}));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_TRUE(world.engine.isIdle());
  EXPECT_LT(translation->translation.getValue().length(), 1000);
  EXPECT_LT(camera->position.getValue().length(), 1000);
}

TEST(TeEngineRuntime, AnObjectWithoutAFiniteOffsetIsSeenFromItsPlace) {
  class Odd final : public TeObject {
  public:
    Odd() : TeObject("odd") {}
    glm::dvec3 thirdPersonOffset() const override { return {0, std::nan(""), 4}; }
  };
  TeEndlessWorld world;
  TeObject* odd = world.engine.addObject(std::make_unique<Odd>());
  ASSERT_TRUE(odd->setPosition({1e5, 0, 60}));
  ASSERT_TRUE(world.engine.initialize());
  ASSERT_TRUE(world.engine.setActiveObject(odd));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  world.engine.finishJobs();
  EXPECT_EQ(world.engine.getCameraRig().eye(), odd->position());
  EXPECT_EQ(world.statistics().patches.drawn, 9);
}

TEST(TeEngineRuntime, AKeyOfTheCameraIsReleasedThoughTheNextActiveObjectUsesItToo) {
  class Greedy final : public TeObject {
  public:
    Greedy() : TeObject("greedy") {}
    bool handleEvent(const TeKeyEvent&) override { return true; }
  };
  TeEndlessWorld world;
  TeObject* greedy = world.engine.addObject(std::make_unique<Greedy>());
  ASSERT_TRUE(world.engine.initialize());
  world.engine.postKey({SoKeyboardEvent::I, true});
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_TRUE(world.engine.getCameraRig().moving());
  ASSERT_TRUE(world.engine.setActiveObject(greedy));
  world.engine.postKey({SoKeyboardEvent::I, false});
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_FALSE(world.engine.getCameraRig().moving());
}

TEST(TeEngineRuntime, AnIdleEngineNoticesAnotherRadius) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 100; ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  ASSERT_TRUE(world.engine.isIdle());
  ASSERT_TRUE(world.engine.setRadius(2));
  EXPECT_FALSE(world.engine.isIdle());
  for (int i = 0; i < 1000 && !world.engine.isIdle(); ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(world.statistics().patches.drawn, 25);
  ASSERT_TRUE(world.engine.setRadius(1));
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(patchesOf(world)->getNumChildren(), 9);
}

TEST(TeEngineRuntime, FinishingMakesWhatWasAskedForSinceTheLastTick) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.initialize());
  const TePatchDatabase& terrain = *world.engine.getDatabase();
  auto other = std::make_unique<TeProbe>("other");
  ASSERT_TRUE(other->setPosition({1e5, 0, 0}));
  world.engine.addObject(std::move(other));
  ASSERT_TRUE(world.engine.setRadius(2));
  world.engine.finishJobs();
  EXPECT_EQ(world.statistics().patches.drawn, 25);
  EXPECT_TRUE(terrain.heightAt({1e5, 0}));
  ASSERT_TRUE(world.object->setPosition({-1e6, 0, 50}));
  world.engine.finishJobs();
  EXPECT_TRUE(terrain.heightAt({-1e6, 0}));
  EXPECT_FALSE(terrain.heightAt({0, 0}));
  EXPECT_EQ(world.statistics().patches.drawn, 25);
}

TEST(TeEngineRuntime, WithoutAFrameDrawnATickerFarAwayComesToRest) {
  TeEndlessWorld world;
  world.engine.setUnitBudget(500);
  ASSERT_TRUE(world.engine.initialize());
  ASSERT_TRUE(world.object->setVelocity({0, 1000, 0})); // without a jump, past the anchor's reach
  for (int i = 0; i < 300; ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  ASSERT_TRUE(world.object->setVelocity({0, 0, 0}));
  for (int i = 0; i < 200 && !world.engine.isIdle(); ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_TRUE(world.engine.isIdle());
}

TEST(TeEngineRuntime, EventsComeInTheirOrderWhateverCallBacksDo) {
  TeEndlessWorld world;
  std::set<TePatchKey> known;
  bool finished = false;
  world.engine.setPatchReadyCallback([&](const TePatchKey& key, SoGroup*) {
    EXPECT_TRUE(known.insert(key).second) << key.text();
    if (known.size() == 2 && !std::exchange(finished, true)) {
      EXPECT_TRUE(world.object->setPosition({1e5, 0, 50}));
      world.engine.finishJobs();
    }
  });
  world.engine.setPatchDroppedCallback(
      [&](const TePatchKey& key, SoGroup*) { EXPECT_EQ(known.erase(key), 1u) << key.text(); });
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  EXPECT_TRUE(finished);
  EXPECT_EQ(std::int64_t(known.size()), world.statistics().patches.resident);
}

TEST(TeEngineRuntime, ACallBackMayReplaceItself) {
  TeEndlessWorld world;
  const std::string words = "what the call-back holds, longer than a string keeps in itself";
  std::string heard;
  world.engine.setPatchReadyCallback([&world, &heard, words](const TePatchKey&, SoGroup*) {
    world.engine.setPatchReadyCallback(nullptr);
    heard += words;
  });
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  EXPECT_EQ(heard, words);
}

TEST(TeEngineRuntime, ATickWithinATickIsAnError) {
  TeEndlessWorld world;
  int calls = 0;
  world.engine.setKeyCallback([&](const TeKeyEvent&) {
    ++calls;
    world.engine.postKey({SoKeyboardEvent::Z, true});
    EXPECT_FALSE(world.engine.timeTick(kDt));
    return true;
  });
  world.engine.setCollisionHook([&](double) { EXPECT_FALSE(world.engine.timeTick(kDt)); });
  ASSERT_TRUE(world.object->setVelocity({1, 0, 0}));
  ASSERT_TRUE(world.engine.initialize());
  world.engine.postKey({SoKeyboardEvent::T, true});
  world.engine.postKey({SoKeyboardEvent::Y, true});
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(world.statistics().ticks, 1);
  ASSERT_TRUE(world.engine.timeTick(kDt));
  EXPECT_EQ(calls, 3);
}

TEST(TeEngineRuntime, AProgramsJobThatFailsIsReported) {
  class FailingJob final : public TeJob {
  public:
    FailingJob() : TeJob(TeJobKind::Other, {}) {}
    TeProgress step(TeAllowance&) override { return TeProgress::Failed; }
    TeJobState state() const override { return TeJobState::Waiting; }
    const TeError& error() const override { return m_error; }

  private:
    TeError m_error{"no trees here"};
  };
  TeEndlessWorld world;
  EXPECT_FALSE(world.engine.addJob(std::make_unique<FailingJob>())) << "before initialize()";
  std::vector<std::string> errors;
  world.engine.setErrorCallback([&](const std::string& message) { errors.push_back(message); });
  ASSERT_TRUE(world.engine.initialize());
  EXPECT_FALSE(world.engine.addJob(nullptr));
  EXPECT_TRUE(world.engine.addJob(std::make_unique<FailingJob>()));
  world.engine.finishJobs();
  EXPECT_EQ(errors, std::vector<std::string>{"no trees here"});
}

TEST(TeEngineRuntime, TheHudOfAnEngineAtRestShowsItsState) {
  TeEndlessWorld world;
  TeNodePtr<SoSeparator> hud(new SoSeparator);
  world.engine.setHudRoot(hud.get());
  world.engine.setHudCamera(new SoOrthographicCamera);
  ASSERT_TRUE(world.engine.initialize());
  for (int i = 0; i < 1000 && !world.engine.isIdle(); ++i)
    ASSERT_TRUE(world.engine.timeTick(kDt));
  ASSERT_TRUE(world.object->setPosition({7.5, 0, 50}));
  for (int i = 0; i < 1000 && !world.engine.isIdle(); ++i)
    ASSERT_TRUE(world.engine.timeTick(1e-3));
  std::string lines;
  for (const std::string& line : world.engine.getHud().lines())
    lines += line + "\n";
  EXPECT_NE(lines.find("position  7.5"), std::string::npos) << lines;
  EXPECT_NE(lines.find("9 of 9"), std::string::npos) << lines;
}

} // namespace
