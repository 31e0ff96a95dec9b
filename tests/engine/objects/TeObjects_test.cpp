#include "engine/objects/TeObjects.h"

#include "engine/objects/TeTestGround.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Writes its name down at every update, and then does what it was told.
class Walker : public TeObject {
public:
  Walker(std::string name, std::vector<std::string>& log) : TeObject(std::move(name)), m_log(log) {
    (void)setVelocity({1, 0, 0});
  }
  void update(const TeUpdate& update) override {
    m_log.push_back(name());
    TeObject::update(update);
    lastStep = update.dt;
    lastTime = update.time;
    if (then)
      then();
  }
  bool needsGround() const override { return ground; }

  bool ground = false;
  double lastStep = 0;
  double lastTime = 0;
  std::function<void()> then;

private:
  std::vector<std::string>& m_log;
};

/// Leaves a place that is no number.
class Broken : public TeObject {
public:
  using TeObject::TeObject;
  void update(const TeUpdate&) override {
    place({0, std::numeric_limits<double>::quiet_NaN(), 0});
    turn({std::numeric_limits<double>::infinity(), 0, 0, 0});
  }
};

class TeObjectsTest : public testing::Test {
protected:
  Walker& addWalker(const std::string& name) {
    return static_cast<Walker&>(**m_objects.add(std::make_unique<Walker>(name, m_log)));
  }
  TeObjects::Tick update(double dt) {
    const TeResult<TeObjects::Tick> tick = m_objects.update(dt, *m_terrain);
    EXPECT_TRUE(tick) << (tick ? "" : tick.error().message);
    return tick ? *tick : TeObjects::Tick();
  }
  std::vector<std::string> takeLog() { return std::exchange(m_log, {}); }

  std::unique_ptr<TePatchDatabase> m_terrain = teNoGround();
  std::vector<std::string> m_log;
  TeObjects m_objects;
};

TEST_F(TeObjectsTest, OnlyThoseThatMoveAreUpdated) {
  TeObject* tower = *m_objects.add(std::make_unique<TeObject>("tower"));
  Walker& walker = addWalker("walker");
  EXPECT_EQ(update(0.05).updates, 2) << "what is new is updated once";
  EXPECT_FALSE(tower->awake());
  EXPECT_EQ(update(0.05).updates, 1);
  EXPECT_THAT(m_objects.touched(), ElementsAre(&walker));
  ASSERT_TRUE(walker.setVelocity({0, 0, 0}));
  update(0.05);
  EXPECT_FALSE(m_objects.anyAwake());
  EXPECT_EQ(update(0.05).updates, 0);
  EXPECT_THAT(m_objects.touched(), IsEmpty());
}

TEST_F(TeObjectsTest, EverySetterWakes) {
  TeObject* tower = *m_objects.add(std::make_unique<TeObject>("tower"));
  const std::vector<std::function<TeStatus()>> setters = {
      [&] {
        return tower->setPosition({1, 2, 3});
      },
      [&] {
        return tower->setVelocity({0, 0, 0});
      },
      [&] {
        return tower->setOrientation({0, 1, 0, 0});
      },
  };
  update(0.05);
  for (const auto& setter : setters) {
    ASSERT_FALSE(m_objects.anyAwake());
    ASSERT_TRUE(setter());
    EXPECT_TRUE(m_objects.anyAwake());
    EXPECT_THAT(m_objects.awake(), ElementsAre(tower));
    EXPECT_EQ(update(0.05).updates, 1);
    EXPECT_THAT(m_objects.touched(), ElementsAre(tower));
  }
}

TEST_F(TeObjectsTest, OrderIsThatOfAdditionWhateverWokeThem) {
  std::vector<Walker*> walkers;
  for (const char* name : {"a", "b", "c", "d", "e"})
    walkers.push_back(&addWalker(name));
  for (Walker* walker : walkers)
    ASSERT_TRUE(walker->setVelocity({0, 0, 0}));
  update(0.05);
  takeLog();
  for (const int i : {3, 0, 4, 2})
    ASSERT_TRUE(walkers[std::size_t(i)]->setVelocity({1, 0, 0}));
  update(0.05);
  EXPECT_THAT(takeLog(), ElementsAre("a", "c", "d", "e"));
  walkers[1]->wake();
  update(0.05);
  EXPECT_THAT(takeLog(), ElementsAre("a", "b", "c", "d", "e"));
}

TEST_F(TeObjectsTest, LongTicksAreDividedAndCut) {
  Walker& walker = addWalker("walker");
  TeObjects::Tick tick = update(0.25);
  EXPECT_EQ(tick.steps, 3);
  EXPECT_EQ(tick.updates, 3);
  EXPECT_DOUBLE_EQ(tick.simulated, 0.25);
  EXPECT_EQ(tick.dropped, 0);
  EXPECT_DOUBLE_EQ(walker.lastStep, 0.25 / 3);
  EXPECT_DOUBLE_EQ(walker.lastTime, 0.25);
  EXPECT_DOUBLE_EQ(walker.position().x, 0.25);

  tick = update(7.5);
  EXPECT_EQ(tick.steps, 10);
  EXPECT_EQ(tick.simulated, 1);
  EXPECT_EQ(tick.dropped, 6.5);
  EXPECT_DOUBLE_EQ(m_objects.time(), 1.25);
  EXPECT_DOUBLE_EQ(walker.position().x, 1.25);
}

TEST_F(TeObjectsTest, NoStepIsLongerThanTheLongest) {
  Walker& walker = addWalker("walker");
  for (double dt = 0.001; dt < 1; dt *= 1.01) {
    update(dt);
    ASSERT_LE(walker.lastStep, TeObjects::kLongestStep) << dt;
    ASSERT_GT(walker.lastStep, 0.49 * std::min(dt, TeObjects::kLongestStep)) << dt;
  }
  for (int i = 1; i <= 10; ++i)
    for (const double dt : {i * 0.1, std::nextafter(i * 0.1, 2.0)}) {
      update(dt);
      ASSERT_LE(walker.lastStep, TeObjects::kLongestStep) << dt;
    }
}

TEST_F(TeObjectsTest, TimeThatStandsStillUpdatesNothing) {
  Walker& walker = addWalker("walker");
  const TeObjects::Tick tick = update(0);
  EXPECT_EQ(tick.updates, 0);
  EXPECT_EQ(tick.steps, 0);
  EXPECT_EQ(m_objects.time(), 0);
  EXPECT_THAT(m_objects.touched(), ElementsAre(&walker)) << "it may have been placed since";
  EXPECT_TRUE(walker.awake());
}

TEST_F(TeObjectsTest, TimesThatAreNoneAreRefused) {
  Walker& walker = addWalker("walker");
  for (const double dt :
       {-1e-9, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    const auto tick = m_objects.update(dt, *m_terrain);
    ASSERT_FALSE(tick) << dt;
    EXPECT_THAT(tick.error().message, HasSubstr("must be 0 or more"));
  }
  EXPECT_EQ(walker.position(), glm::dvec3(0));
  EXPECT_EQ(m_objects.time(), 0);
}

TEST_F(TeObjectsTest, WhatNeedsGroundIsHeldUntilThereIsSome) {
  Walker& car = addWalker("car");
  car.ground = true;
  addWalker("aircraft");
  TeObjects::Tick tick = update(0.05);
  EXPECT_EQ(tick.held, 1);
  EXPECT_THAT(takeLog(), ElementsAre("aircraft"));
  EXPECT_EQ(car.position(), glm::dvec3(0));
  EXPECT_TRUE(m_objects.anyAwake());

  ASSERT_TRUE(m_terrain->build({0, 0}));
  tick = update(0.05);
  EXPECT_EQ(tick.held, 0);
  EXPECT_THAT(takeLog(), ElementsAre("car", "aircraft"));
  EXPECT_DOUBLE_EQ(car.position().x, 0.05) << "the time it was held is not made up for";
}

TEST_F(TeObjectsTest, WhatBreaksIsPutBackStoppedAndReported) {
  TeObject* broken = *m_objects.add(std::make_unique<Broken>("broken"));
  ASSERT_TRUE(broken->setPosition({1, 2, 3}));
  ASSERT_TRUE(broken->setVelocity({4, 5, 6}));
  Walker& walker = addWalker("walker");
  const TeObjects::Tick tick = update(0.5);
  ASSERT_EQ(tick.errors.size(), 1u) << "once, not in every step";
  EXPECT_THAT(tick.errors[0], HasSubstr("broken: its update at 0.1 s left"));
  EXPECT_EQ(broken->position(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(broken->velocity(), glm::dvec3(0));
  EXPECT_EQ(broken->orientation(), glm::dquat(1, 0, 0, 0));
  EXPECT_FALSE(broken->awake());
  EXPECT_DOUBLE_EQ(walker.position().x, 0.5) << "the others go on";
}

TEST_F(TeObjectsTest, RefusesNothingAndPlacesThatAreNone) {
  EXPECT_EQ(m_objects.add(nullptr).error().message, "TeObjects: no object given");
  class Nowhere : public TeObject {
  public:
    Nowhere() : TeObject("nowhere") { place({0, std::numeric_limits<double>::infinity(), 0}); }
  };
  EXPECT_FALSE(m_objects.add(std::make_unique<Nowhere>()));
  EXPECT_TRUE(m_objects.all().empty());
  EXPECT_FALSE(m_objects.anyAwake());
}

TEST_F(TeObjectsTest, RemovedOnesAreGone) {
  Walker& a = addWalker("a");
  Walker& b = addWalker("b");
  update(0.05);
  takeLog();
  EXPECT_TRUE(m_objects.remove(&a));
  EXPECT_FALSE(m_objects.remove(&a)) << "only its pointer is looked at";
  EXPECT_FALSE(m_objects.remove(nullptr));
  EXPECT_THAT(m_objects.touched(), ElementsAre(&b));
  update(0.05);
  EXPECT_THAT(takeLog(), ElementsAre("b"));
  EXPECT_EQ(m_objects.all().size(), 1u);
}

TEST_F(TeObjectsTest, ObjectsMayRemoveAnyWhileTheyAreUpdated) {
  // Each of five removes each of five, itself too, at its turn.
  for (int remover = 0; remover < 5; ++remover)
    for (int removed = 0; removed < 5; ++removed) {
      TeObjects objects;
      std::vector<std::string> log;
      std::vector<Walker*> walkers;
      for (const char* name : {"0", "1", "2", "3", "4"})
        walkers.push_back(static_cast<Walker*>(*objects.add(std::make_unique<Walker>(name, log))));
      Walker& active = *walkers[std::size_t(remover)];
      bool there = true;
      active.then = [&] {
        EXPECT_EQ(objects.remove(walkers[std::size_t(removed)]), std::exchange(there, false));
      };
      ASSERT_TRUE(objects.update(0.2, *m_terrain));
      // In the first step all before the removed one and, after the remover, all but it; then all others.
      std::vector<std::string> expected;
      for (int step = 0; step < 2; ++step)
        for (int i = 0; i < 5; ++i)
          if (i != removed || (step == 0 && i <= remover))
            expected.push_back(std::to_string(i));
      ASSERT_EQ(log, expected) << remover << " removes " << removed;
      EXPECT_EQ(objects.all().size(), 4u);
      EXPECT_EQ(objects.touched().size(), 4u);
      EXPECT_EQ(objects.awake().size(), 4u);
    }
}

TEST_F(TeObjectsTest, ObjectsMayAddAndWakeOthersWhileTheyAreUpdated) {
  Walker& sleeper = addWalker("sleeper");
  ASSERT_TRUE(sleeper.setVelocity({0, 0, 0}));
  update(0.05);
  takeLog();
  Walker& parent = addWalker("parent");
  parent.then = [&] {
    if (m_objects.all().size() == 2)
      addWalker("child");
    sleeper.wake();
  };
  update(0.2);
  EXPECT_THAT(takeLog(), ElementsAre("parent", "sleeper", "parent", "child"));
  EXPECT_EQ(m_objects.touched().size(), 3u);
}

TEST_F(TeObjectsTest, StateHashIsOfAllInOrderOfAddition) {
  addWalker("a");
  addWalker("b");
  const std::uint64_t before = m_objects.stateHash();
  TeObjects other;
  (void)other.add(std::make_unique<Walker>("b", m_log));
  (void)other.add(std::make_unique<Walker>("a", m_log));
  EXPECT_NE(other.stateHash(), before);
  update(0.05);
  EXPECT_NE(m_objects.stateHash(), before);
}

TEST_F(TeObjectsTest, ARemovedObjectLivesUntilTheTickIsOver) {
  Walker& a = addWalker("a");
  a.then = [&] {
    m_objects.remove(&a);
    EXPECT_TRUE(a.setVelocity({0, 5, 0})); // still there until the tick is over
    a.wake();
  };
  update(0.5);
  EXPECT_THAT(takeLog(), ElementsAre("a"));
  EXPECT_FALSE(m_objects.anyAwake());
  EXPECT_TRUE(m_objects.all().empty());
}

} // namespace
