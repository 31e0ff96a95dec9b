#include "engine/jobs/TePatchTestJob.h"

#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace {

constexpr int kRadius = 1;

std::unique_ptr<TePatchDatabase> database(int samples = 65) {
  return teTestDatabase(std::make_shared<TeHashSource>(), samples);
}

bool holds(const TeJobQueue& queue, TeJobState state) {
  TeStatistics::Jobs jobs;
  queue.count(jobs);
  for (const auto& kind : jobs.now)
    if (kind[std::size_t(state)] > 0)
      return true;
  return false;
}

} // namespace

// Everything is destroyed with a job in each state, and after each number of units; with workers, in the
// middle of maps.
TEST(HardCase, EvictionInUseEngine) {
  int destroyed = 0;
  for (int workers : {0, 1, 4}) {
    for (TeJobState state :
         {TeJobState::Waiting, TeJobState::SourceMaps, TeJobState::Blend, TeJobState::Arrays}) {
      TePatchWorkshop shop(database(257)); // arrays of several units
      ASSERT_TRUE(shop.maker.setWorkers(workers));
      shop.addBlock(kRadius);
      while (!holds(shop.queue, state)) {
        ASSERT_FALSE(shop.queue.empty()) << "never " << teJobStateName(state);
        shop.tick(TeAllowance::units(1));
      }
      ++destroyed;
    }
    bool more = true;
    for (int units = 0; more; units = units < 40 ? units + 1 : units + 37, ++destroyed) {
      TePatchWorkshop shop(database());
      ASSERT_TRUE(shop.maker.setWorkers(workers));
      shop.addBlock(kRadius);
      for (int i = 0; i < units; ++i)
        shop.tick(TeAllowance::units(1));
      more = !shop.queue.empty() && units < 10000;
      if (units % 3 == 1)
        shop.queue.clear(); // the queue first
    }
  }

  // Patches and their maps are evicted between ticks, while jobs and workers use them. All are made anew when
  // they are asked for, with the same bits.
  const auto reference = database();
  int evicted = 0;
  for (int workers : {0, 3}) {
    TePatchWorkshop shop(database());
    ASSERT_TRUE(shop.maker.setWorkers(workers));
    for (int round = 0; round < 3; ++round) {
      shop.addBlock(kRadius);
      for (int tick = 0; !shop.queue.empty(); ++tick) {
        shop.tick(TeAllowance::units(5));
        const TePatchKey victim{tick % 3 - 1, tick / 3 % 3 - 1, 0};
        bool inUse = false; // its arrays are being made from its heights
        shop.queue.review([&](TeJob& job, TeJobKind&, TeUrgency&) {
          inUse = inUse || (job.state() == TeJobState::Arrays && job.urgency().key == victim);
          return true;
        });
        evicted += !inUse && shop.database->remove(victim) ? 1 : 0;
      }
    }
    shop.addBlock(kRadius);
    while (!shop.queue.empty())
      shop.tick(TeAllowance::units(50));
    for (int y = -kRadius; y <= kRadius; ++y)
      for (int x = -kRadius; x <= kRadius; ++x)
        ASSERT_EQ(shop.database->find({x, y, 0})->heights(), (*reference->build({x, y, 0}))->heights());
  }
  EXPECT_GT(evicted, 10);
  std::printf("EvictionInUseEngine: destroyed %d times in every state of jobs, %d evictions in use\n",
              destroyed, evicted);
}
