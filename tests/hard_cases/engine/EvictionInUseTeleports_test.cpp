#include "tests/engine/TeEndlessWorld.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

/// What a block and all that may be on its way take: nothing may pile up beyond it.
TEST(HardCase, EvictionInUseTeleports) {
  TeEndlessWorld world(17, 64);
  world.engine.setUnitBudget(12);
  world.engine.setWorkers(2);
  ASSERT_TRUE(world.engine.initialize());
  world.engine.finishJobs();
  TeRandom random(3, 1, {0, 0});
  std::int64_t mostJobs = 0;
  std::int64_t mostTicks = 0;
  std::int64_t mostResident = 0;
  for (int jump = 0; jump < 1000; ++jump) {
    const double range = std::ldexp(1.0, int(random.below(50)));
    const double x = random.uniform(-range, range);
    const double y = random.uniform(-range, range);
    ASSERT_TRUE(world.object->setPosition({x, y, 100}));
    std::int64_t ticks = 0;
    do {
      ASSERT_TRUE(world.engine.timeTick(1.0 / 30));
      ++ticks;
      std::int64_t jobs = 0;
      for (const auto& kind : world.statistics().jobs.now)
        for (const std::int64_t count : kind)
          jobs += count;
      mostJobs = std::max(mostJobs, jobs);
    } while (!world.engine.getDatabase()->heightAt({x, y}) && ticks < 50);
    mostTicks = std::max(mostTicks, ticks);
    mostResident = std::max(mostResident, world.statistics().patches.resident);
  }
  world.engine.finishJobs();
  EXPECT_EQ(world.statistics().patches.drawn, 9);
  EXPECT_LE(mostTicks, 5) << "until the ground is there";
  EXPECT_LE(mostJobs, 9 * 10) << "jobs of places left behind";
  EXPECT_LE(mostResident, 4 * 25) << "patches of places left behind";
  std::printf(
      "1000 teleports: ground after at most %lld ticks; at most %lld jobs and %lld patches at a time; "
      "peak %.2f MB, of that %.0f bytes of records a patch\n",
      (long long)mostTicks, (long long)mostJobs, (long long)mostResident,
      double(world.statistics().peak.total()) / 1e6,
      double(world.statistics().peak.records) / double(world.statistics().patches.made));
}

TEST(HardCase, EvictionInUseEngine) {
  int engines = 0;
  std::int64_t states[kTeJobStates] = {};
  for (const int workers : {0, 2})
    for (int units = 1; units <= 120; units += 1) {
      TeEndlessWorld world;
      world.engine.setWorkers(workers);
      world.engine.setUnitBudget(units);
      ASSERT_TRUE(world.engine.initialize());
      ASSERT_TRUE(world.engine.timeTick(1.0 / 30));
      for (const auto& kind : world.statistics().jobs.now)
        for (int state = 0; state < kTeJobStates; ++state)
          states[state] += kind[std::size_t(state)] > 0 ? 1 : 0;
      ++engines;
    }
  std::printf("%d engines destroyed while they worked, with jobs:", engines);
  for (int state = 0; state < kTeJobStates; ++state)
    if (states[state] > 0)
      std::printf(" %s %lld", teJobStateName(TeJobState(state)), (long long)states[state]);
  std::printf("\n");
  for (const TeJobState state : {TeJobState::Waiting, TeJobState::SourceMaps, TeJobState::Model})
    EXPECT_GT(states[int(state)], 0) << teJobStateName(state);
}

} // namespace
