#include "engine/jobs/TeMapMaker.h"

#include "patchdb/TePatchJob.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

namespace {

/// Counts how often it was asked for each map; optionally fails, or makes workers wait until they
/// are let go.
class CountingSource final : public TePointSource {
public:
  std::string name() const override { return "counting"; }
  std::uint64_t fingerprint() const override { return 5; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    if (samples[0].column == 0 && samples[0].row == 0)
      ++m_begun;
    while (m_held && !m_given && std::this_thread::get_id() != m_maker)
      std::this_thread::yield();
    if (m_fails)
      return TeError{"no luck"};
    return m_heights->evaluate(request, samples, count, heights);
  }

  mutable std::atomic<int> m_begun{0};
  std::atomic<bool> m_fails{false};
  std::atomic<bool> m_held{false};
  std::atomic<bool> m_given{false};

private:
  const std::thread::id m_maker = std::this_thread::get_id();
  std::shared_ptr<TeHashSource> m_heights = std::make_shared<TeHashSource>();
};

using Jobs = std::vector<std::unique_ptr<TePatchJob>>;

Jobs blockOfJobs(TePatchDatabase& database, TeMapMaker& maker, int radius) {
  Jobs jobs;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x)
      jobs.push_back(std::make_unique<TePatchJob>(database, TePatchKey{x, y, 0}, &maker));
  return jobs;
}

/// Ticks until all have ended; the number of ticks. Leaves workers some time between them.
int runAll(Jobs& jobs, TeMapMaker& maker, int units) {
  int ticks = 0;
  for (bool working = true; working && ticks < 100000; ++ticks) {
    working = false;
    maker.beginTick();
    TeAllowance allowance = TeAllowance::units(units);
    for (auto& job : jobs) {
      if (!job->blocked() && !allowance.exhausted())
        job->step(allowance);
      working = working || job->progress() == TeProgress::Working;
    }
    if (maker.handedOver() > 0)
      std::this_thread::sleep_for(std::chrono::microseconds(20));
  }
  return ticks;
}

} // namespace

TEST(TeMapMaker, MakesEveryMapOnceForAllPatchesThatNeedIt) {
  const auto reference = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  for (int workers : {0, 1, 4})
    for (int units : {1, 7, 1000}) {
      const auto source = std::make_shared<CountingSource>();
      const auto database = teTestDatabase(source, 17);
      TeMapMaker maker(*database);
      ASSERT_TRUE(maker.setWorkers(workers));
      EXPECT_EQ(maker.workers(), workers);
      Jobs jobs = blockOfJobs(*database, maker, 1);
      runAll(jobs, maker, units);
      EXPECT_EQ(source->m_begun, 16);
      EXPECT_EQ(maker.mapsMade(), 16);
      EXPECT_EQ(maker.mapsShared(), 20);
      EXPECT_EQ(maker.requested(), 0u);
      EXPECT_EQ(maker.handedOver(), 0u);
      for (const auto& job : jobs) {
        ASSERT_EQ(job->progress(), TeProgress::Done);
        EXPECT_EQ(database->find(job->key())->heights(), (*reference->build(job->key()))->heights());
      }
    }
}

TEST(TeMapMaker, AMapIsKeptForAllThatWaitThoughTheFirstHasGone) {
  const auto source = std::make_shared<CountingSource>();
  const auto database = teTestDatabase(source, 17);
  TeMapMaker maker(*database);
  TePatchJob waits(*database, {1, 0, 0}, &maker);
  TeAllowance one = TeAllowance::units(1);
  waits.step(one); // requests its maps, two of which it shares with the other
  {
    TePatchJob first(*database, {0, 0, 0}, &maker);
    EXPECT_EQ(first.finish(), TeProgress::Done);
    database->remove({0, 0, 0});
  }
  EXPECT_EQ(waits.finish(), TeProgress::Done);
  EXPECT_EQ(source->m_begun, 6);
}

TEST(TeMapMaker, HandsOverOnlySoManyMapsAtATimeAndMakesTheOthersItself) {
  const auto source = std::make_shared<CountingSource>();
  source->m_held = true;
  const auto database = teTestDatabase(source, 513); // maps of 1 MiB
  TeMapMaker maker(*database);
  ASSERT_TRUE(maker.setWorkers(2));
  Jobs jobs = blockOfJobs(*database, maker, 1);
  for (auto& job : jobs) {
    TeAllowance allowance = TeAllowance::units(10);
    job->step(allowance);
  }
  EXPECT_EQ(maker.handedOver(), 2 * 3u) << "as many as fit into 4 MiB a worker";
  EXPECT_FALSE(maker.beginTick());
  EXPECT_EQ(jobs.back()->finish(), TeProgress::Done) << "a job with no map at a worker";
  source->m_given = true;
  EXPECT_TRUE(maker.joinAll());
  EXPECT_EQ(maker.handedOver(), 0u);
  runAll(jobs, maker, 100);
  EXPECT_EQ(maker.mapsMade(), 16);
}

TEST(TeMapMaker, AJobInAHurryWaitsForNoWorker) {
  for (const bool fixedJoin : {false, true}) {
    const auto source = std::make_shared<CountingSource>();
    source->m_held = true;
    const auto database = teTestDatabase(source, 17);
    TeMapMaker maker(*database);
    maker.setFixedJoin(fixedJoin);
    ASSERT_TRUE(maker.setWorkers(1));
    TePatchJob job(*database, {0, 0, 0}, &maker);
    TeAllowance some = TeAllowance::units(10);
    EXPECT_EQ(job.step(some), TeProgress::Working);
    EXPECT_TRUE(job.blocked());
    job.hurry();
    EXPECT_FALSE(job.blocked());
    EXPECT_EQ(job.finish(), TeProgress::Done) << "while the worker is still held up";
    source->m_given = true;
  }
}

TEST(TeMapMaker, WithAFixedJoinTicksDoNotDependOnTheSpeedOfWorkers) {
  std::vector<int> ticks;
  for (int run = 0; run < 5; ++run) {
    const auto database = teTestDatabase(std::make_shared<TeHashSource>(), run % 2 ? 65 : 17);
    TeMapMaker maker(*database);
    maker.setFixedJoin(true);
    ASSERT_TRUE(maker.setWorkers(3));
    Jobs jobs = blockOfJobs(*database, maker, 2);
    ticks.push_back(runAll(jobs, maker, 5));
  }
  EXPECT_EQ(ticks[0], ticks[2]);
  EXPECT_EQ(ticks[0], ticks[4]);
  EXPECT_EQ(ticks[1], ticks[3]);
}

TEST(TeMapMaker, AbandonedMapsAreCancelled) {
  for (int workers : {0, 2}) {
    const auto source = std::make_shared<CountingSource>();
    const auto database = teTestDatabase(source, 65);
    TeMapMaker maker(*database);
    ASSERT_TRUE(maker.setWorkers(workers));
    Jobs jobs = blockOfJobs(*database, maker, 2);
    for (auto& job : jobs) {
      TeAllowance one = TeAllowance::units(1);
      job->step(one);
    }
    EXPECT_GT(maker.requested(), 0u);
    jobs.clear();
    EXPECT_EQ(maker.requested(), 0u);
    EXPECT_EQ(maker.handedOver(), 0u);
    maker.joinAll();
    EXPECT_EQ(maker.mapsMade(), 0);
    EXPECT_EQ(database->maps().residentMaps(), 0u);
  }
}

TEST(TeMapMaker, HalfMadeMapsAreLimitedAndStillAllAreMade) {
  const auto source = std::make_shared<CountingSource>();
  const auto database = teTestDatabase(source, 17);
  TeMapMaker maker(*database);
  Jobs jobs = blockOfJobs(*database, maker, 3);
  for (int round = 0; round < 3; ++round) // more maps are begun than may be half made
    for (auto& job : jobs) {
      TeAllowance one = TeAllowance::units(1);
      job->step(one);
    }
  for (auto& job : jobs)
    EXPECT_EQ(job->finish(), TeProgress::Done);
  EXPECT_EQ(maker.mapsMade(), 64);
}

TEST(TeMapMaker, AFailureReachesAllThatWaitAndIsForgottenThen) {
  for (int workers : {0, 2}) {
    const auto source = std::make_shared<CountingSource>();
    source->m_fails = true;
    const auto database = teTestDatabase(source, 17);
    TeMapMaker maker(*database);
    ASSERT_TRUE(maker.setWorkers(workers));
    Jobs jobs;
    for (int x : {0, 1})
      jobs.push_back(std::make_unique<TePatchJob>(*database, TePatchKey{x, 0, 0}, &maker));
    runAll(jobs, maker, 1);
    for (auto& job : jobs) {
      ASSERT_EQ(job->progress(), TeProgress::Failed);
      EXPECT_NE(job->error().message.find("): no luck"), std::string::npos) << job->error().message;
    }
    EXPECT_EQ(maker.requested(), 0u);
    source->m_fails = false;
    TePatchJob again(*database, {0, 0, 0}, &maker);
    while (again.step(*std::make_unique<TeAllowance>(TeAllowance::unlimited())) == TeProgress::Working)
      maker.joinAll();
    EXPECT_EQ(again.progress(), TeProgress::Done);
  }
}

TEST(TeMapMaker, WorkersMayChangeAtAnyTime) {
  const auto source = std::make_shared<CountingSource>();
  const auto database = teTestDatabase(source, 65);
  const auto reference = teTestDatabase(std::make_shared<TeHashSource>(), 65);
  TeMapMaker maker(*database);
  EXPECT_FALSE(maker.setWorkers(-1));
  EXPECT_FALSE(maker.setWorkers(1000));
  EXPECT_EQ(maker.workers(), 0);
  Jobs jobs = blockOfJobs(*database, maker, 2);
  for (int workers : {0, 2, 1, 0, 3}) {
    ASSERT_TRUE(maker.setWorkers(workers));
    for (auto& job : jobs) {
      TeAllowance some = TeAllowance::units(2);
      job->step(some);
    }
  }
  runAll(jobs, maker, 50);
  for (auto& job : jobs)
    EXPECT_EQ(database->find(job->key())->heights(), (*reference->build(job->key()))->heights());
}
