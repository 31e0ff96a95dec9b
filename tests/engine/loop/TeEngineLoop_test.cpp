#include "engine/loop/TeEngineLoop.h"

#include "tests/engine/TeEndlessWorld.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoHandleEventAction.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/sensors/SoNodeSensor.h>
#include <Inventor/sensors/SoSensorManager.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

/// An engine in a loop, whose sensors are served here as a window toolkit would.
class TeEngineLoopTest : public testing::Test {
protected:
  /// Coin's own timer, which keeps its field of the real time up to date, would always be pending.
  TeEngineLoopTest() { SoDB::setRealTimeInterval(SbTime::zero()); }

  void start() {
    SoDB::setRealTimeInterval(SbTime::zero()); // Coin's own clock has a sensor, too
    ASSERT_TRUE(m_world.engine.setUnitBudget(2)) << "so that the block takes several ticks";
    ASSERT_TRUE(m_world.engine.initialize()) << m_world.engine.lastError();
    m_loop = std::make_unique<TeEngineLoop>(m_world.engine, m_world.scene.get());
    m_loop->start();
  }
  /// Until the loop sleeps, and the timer with which Coin sees to its queue has run out.
  void settle() {
    for (int i = 0; i < 10000 && loop().state() != TeEngineLoop::State::Sleeping; ++i)
      serve(true);
    serveFor(0.1);
    ASSERT_EQ(loop().state(), TeEngineLoop::State::Sleeping);
  }
  /// What is due now; idle sensors only if asked for.
  static void serve(bool idle) {
    SoSensorManager& sensors = *SoDB::getSensorManager();
    sensors.processTimerQueue();
    sensors.processDelayQueue(idle);
  }
  /// For so many seconds of the clock.
  static void serveFor(double seconds) {
    const SbTime end = SbTime::getTimeOfDay() + SbTime(seconds);
    while (SbTime::getTimeOfDay() < end)
      serve(true);
  }
  static bool pending() {
    SbTime alarm;
    SoSensorManager& sensors = *SoDB::getSensorManager();
    return sensors.isDelaySensorPending() || sensors.isTimerSensorPending(alarm);
  }

  void press(SoKeyboardEvent::Key key, bool down = true) {
    SoKeyboardEvent event;
    event.setKey(key);
    event.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
    SoHandleEventAction action(SbViewportRegion(100, 100));
    action.setEvent(&event);
    action.apply(m_world.scene.get());
  }

  TeEndlessWorld& world() { return m_world; }
  TeEngineLoop& loop() { return *m_loop; }
  std::int64_t ticks() const { return m_world.statistics().ticks; }

private:
  TeEndlessWorld m_world;
  std::unique_ptr<TeEngineLoop> m_loop;
};

TEST_F(TeEngineLoopTest, AnIdleEngineHasNoSensorNoTickAndNoRedraw) {
  start();
  settle();
  const std::int64_t before = ticks();
  int changes = 0;
  SoNodeSensor watch([](void* count, SoSensor*) { ++*static_cast<int*>(count); }, &changes);
  watch.setPriority(0);
  watch.attach(world().scene.get());
  serveFor(0.2);
  EXPECT_FALSE(pending());
  EXPECT_EQ(ticks(), before);
  EXPECT_EQ(changes, 0);
}

TEST_F(TeEngineLoopTest, JobsAreDoneWhileTheProgramIsIdle) {
  ASSERT_TRUE(world().engine.setBudget(1e-5));
  start();
  serve(true); // the first tick
  ASSERT_EQ(loop().state(), TeEngineLoop::State::Working);
  const std::int64_t before = ticks();
  serve(false); // events to be handled: not idle
  EXPECT_EQ(ticks(), before);
  settle();
  EXPECT_GT(ticks(), before);
  EXPECT_EQ(world().statistics().patches.drawn, 9);
}

TEST_F(TeEngineLoopTest, AKeyWakesIt) {
  start();
  settle();
  int keys = 0;
  world().engine.setKeyCallback([&](const TeKeyEvent& key) {
    keys += key.key == SoKeyboardEvent::Z && key.down;
    return true;
  });
  press(SoKeyboardEvent::Z);
  EXPECT_NE(loop().state(), TeEngineLoop::State::Sleeping);
  settle();
  EXPECT_EQ(keys, 1);
}

TEST_F(TeEngineLoopTest, RepetitionsOfAHeldKeyAreLeftOut) {
  start();
  int downs = 0, ups = 0;
  loop().setKeyFilter([&](const TeKeyEvent& key) {
    ++(key.down ? downs : ups);
    return true;
  });
  press(SoKeyboardEvent::Z, false); // it went down in another window
  for (int i = 0; i < 5; ++i)
    press(SoKeyboardEvent::Z);
  EXPECT_EQ(downs, 1);
  EXPECT_EQ(ups, 0);
  loop().releaseKeys();
  EXPECT_EQ(ups, 1);
  press(SoKeyboardEvent::Z);
  EXPECT_EQ(downs, 2);
}

TEST_F(TeEngineLoopTest, AFilterKeepsKeysFromTheEngine) {
  start();
  settle();
  loop().setKeyFilter([](const TeKeyEvent&) { return false; });
  press(SoKeyboardEvent::Z);
  EXPECT_EQ(loop().state(), TeEngineLoop::State::Sleeping);
}

TEST_F(TeEngineLoopTest, AMovingObjectIsTickedAtTheRate) {
  ASSERT_TRUE(world().object->setVelocity({0, 10, 0}));
  start();
  ASSERT_TRUE(loop().setRate(50));
  serve(true);
  EXPECT_EQ(loop().state(), TeEngineLoop::State::Moving);
  const std::int64_t before = ticks();
  serveFor(0.5);
  EXPECT_LE(ticks() - before, 26);
  EXPECT_GE(ticks() - before, 5); // of 25; the machine may be busy
  EXPECT_GT(world().object->position().y, 2);
}

TEST_F(TeEngineLoopTest, TimeGoesOnAsItPassesUnlessItIsGiven) {
  ASSERT_TRUE(world().object->setVelocity({0, 10, 0}));
  start();
  double passed = 0;
  int calls = 0;
  loop().setBeforeTick([&](double seconds) {
    passed += seconds;
    ++calls;
    return 0.25;
  });
  serveFor(0.3);
  EXPECT_NEAR(passed, 0.3, 0.2);
  EXPECT_GT(calls, 2);
  EXPECT_NEAR(world().object->position().y, 2.5 * calls, 1e-9);
}

TEST_F(TeEngineLoopTest, AChangeOfTheSceneWakesIt) {
  start();
  settle();
  const std::int64_t before = ticks();
  world().scene->touch();
  settle();
  serveFor(0.05);
  EXPECT_EQ(ticks(), before + 1);
  EXPECT_FALSE(pending());
}

TEST_F(TeEngineLoopTest, AProgramWakesItAfterChangesThatItCannotSee) {
  start();
  settle();
  ASSERT_TRUE(world().object->setVelocity({0, 10, 0}));
  loop().wake();
  serveFor(0.1);
  EXPECT_EQ(loop().state(), TeEngineLoop::State::Moving);
  EXPECT_GT(world().object->position().y, 0);
}

TEST_F(TeEngineLoopTest, AStoppedOrDeletedLoopTicksNoMore) {
  ASSERT_TRUE(world().object->setVelocity({0, 10, 0}));
  start();
  serve(true);
  loop().stop();
  const std::int64_t before = ticks();
  serveFor(0.1);
  EXPECT_EQ(ticks(), before);
  EXPECT_FALSE(pending());
  loop().start();
  serve(true);
  EXPECT_GT(ticks(), before);
}

TEST_F(TeEngineLoopTest, ACallbackMayStopIt) {
  ASSERT_TRUE(world().object->setVelocity({0, 10, 0}));
  start();
  loop().setAfterTick([&] { loop().stop(); });
  serveFor(0.1);
  EXPECT_EQ(ticks(), 1);
  EXPECT_EQ(loop().state(), TeEngineLoop::State::Stopped);
}

TEST_F(TeEngineLoopTest, RatesOutOfRangeAreErrors) {
  start();
  for (const double rate : {0.0, -1.0, 0.5, 1e9, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(loop().setRate(rate)) << rate;
}

} // namespace
