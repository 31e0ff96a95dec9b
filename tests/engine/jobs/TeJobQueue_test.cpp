#include "engine/jobs/TeJobQueue.h"

#include "engine/TeStatistics.h"
#include "engine/jobs/TeCountingJob.h"
#include "engine/jobs/TeJobKind.h"
#include "engine/jobs/TeJobState.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace {

std::unique_ptr<TeCountingJob> job(TeJobKind kind, double distance, std::int64_t units = 1,
                                   TePatchKey key = {}) {
  return std::make_unique<TeCountingJob>(kind, TeUrgency{0, distance, key}, units);
}

/// Runs all that is left and tells the distances of the jobs in the order in which they ended.
std::vector<double> order(TeJobQueue& queue) {
  std::vector<double> distances;
  queue.setFinished([&](TeJob& ended, TeProgress) { distances.push_back(ended.urgency().distance); });
  TeAllowance all = TeAllowance::unlimited();
  queue.run(all);
  return distances;
}

} // namespace

TEST(TeJobQueue, RunsTheMostUrgentFirstAndGroundBeforeAll) {
  TeJobQueue queue;
  queue.add(job(TeJobKind::Block, 2));
  queue.add(job(TeJobKind::Block, 1));
  queue.add(job(TeJobKind::Ground, 9));
  queue.add(std::make_unique<TeCountingJob>(TeJobKind::Block, TeUrgency{-1, 5, {}}));
  queue.add(job(TeJobKind::Ground, 8));
  EXPECT_EQ(queue.size(), 5u);
  EXPECT_EQ(order(queue), (std::vector<double>{8, 9, 5, 1, 2}));
  EXPECT_TRUE(queue.empty());
}

TEST(TeJobQueue, StopsWithTheAllowanceAndGoesOnWhereItWas) {
  TeJobQueue queue;
  const TeCountingJob& first = static_cast<TeCountingJob&>(queue.add(job(TeJobKind::Block, 1, 10)));
  queue.add(job(TeJobKind::Block, 2, 10));
  TeAllowance some = TeAllowance::units(7);
  EXPECT_TRUE(queue.run(some));
  EXPECT_EQ(some.unitsSpent(), 7);
  EXPECT_EQ(first.done(), 7);
  EXPECT_EQ(queue.size(), 2u);
  TeAllowance more = TeAllowance::units(7);
  EXPECT_TRUE(queue.run(more));
  EXPECT_EQ(queue.size(), 1u);
  TeAllowance none = TeAllowance::units(0); // one unit all the same
  EXPECT_TRUE(queue.run(none));
  EXPECT_EQ(none.unitsSpent(), 1);
  queue.clear();
  EXPECT_FALSE(queue.run(more));
}

TEST(TeJobQueue, EveryKindGetsItsShareOverTheTicks) {
  TeJobQueue queue;
  for (TeJobKind kind : {TeJobKind::Block, TeJobKind::Ahead, TeJobKind::Other})
    queue.add(job(kind, 1, 1000000));
  const auto unitsOf = [&](int ticks) {
    std::array<double, kTeJobKinds> units{};
    queue.review([&](TeJob& each, TeJobKind& kind, TeUrgency&) {
      units[std::size_t(kind)] -= double(static_cast<TeCountingJob&>(each).done());
      return true;
    });
    for (int tick = 0; tick < ticks; ++tick) {
      TeAllowance allowance = TeAllowance::units(10 + tick % 7);
      queue.run(allowance);
    }
    double sum = 0;
    queue.review([&](TeJob& each, TeJobKind& kind, TeUrgency&) {
      units[std::size_t(kind)] += double(static_cast<TeCountingJob&>(each).done());
      sum += units[std::size_t(kind)];
      return true;
    });
    for (double& share : units)
      share /= sum;
    return units;
  };
  const auto all = unitsOf(1000);
  for (TeJobKind kind : {TeJobKind::Block, TeJobKind::Ahead, TeJobKind::Other})
    EXPECT_NEAR(all[std::size_t(kind)], TeJobQueue::kShares[std::size_t(kind)], 0.01) << teJobKindName(kind);

  // What nobody of a kind needs goes to the most urgent of the others.
  queue.review([](TeJob&, TeJobKind& kind, TeUrgency&) { return kind != TeJobKind::Block; });
  const auto two = unitsOf(1000);
  EXPECT_NEAR(two[std::size_t(TeJobKind::Ahead)], 0.9, 0.01);
  EXPECT_NEAR(two[std::size_t(TeJobKind::Other)], 0.1, 0.01);
}

TEST(TeJobQueue, PassesOverBlockedJobs) {
  TeJobQueue queue;
  auto& first = static_cast<TeCountingJob&>(queue.add(job(TeJobKind::Ground, 1)));
  auto& second = static_cast<TeCountingJob&>(queue.add(job(TeJobKind::Ground, 2, 5)));
  first.m_blocked = true;
  second.m_onUnit = [](TeCountingJob& self) { self.m_blocked = self.done() == 2; };
  queue.add(job(TeJobKind::Ahead, 3));
  EXPECT_FALSE(queue.allBlocked());
  TeAllowance all = TeAllowance::units(2);
  queue.run(all);
  EXPECT_EQ(second.done(), 2);
  TeAllowance more = TeAllowance::unlimited();
  EXPECT_TRUE(queue.run(more)); // the one ahead
  EXPECT_EQ(queue.size(), 2u);
  EXPECT_TRUE(queue.allBlocked());
  EXPECT_FALSE(queue.run(more));
  first.m_blocked = second.m_blocked = false;
  EXPECT_EQ(order(queue), (std::vector<double>{1, 2}));
  EXPECT_FALSE(queue.allBlocked());
}

TEST(TeJobQueue, ReviewMovesAndCancels) {
  TeJobQueue queue;
  for (int i = 0; i < 6; ++i)
    queue.add(job(TeJobKind::Ahead, i));
  TeAllowance one = TeAllowance::units(1);
  queue.run(one);
  int asked = 0;
  queue.review([&](TeJob& each, TeJobKind& kind, TeUrgency& urgency) {
    ++asked;
    EXPECT_EQ(each.kind(), kind);
    if (urgency.distance == 3)
      return false;
    if (urgency.distance == 2)
      kind = TeJobKind::Ground;
    if (urgency.distance == 4)
      kind = TeJobKind::Block;
    urgency.distance = 10 - urgency.distance;
    return true;
  });
  EXPECT_EQ(asked, 5);
  EXPECT_EQ(order(queue), (std::vector<double>{8, 6, 5, 9}));
  TeStatistics::Jobs jobs;
  queue.count(jobs);
  EXPECT_EQ(jobs.cancelled[std::size_t(TeJobKind::Ahead)], 1);
  EXPECT_EQ(jobs.finished[std::size_t(TeJobKind::Ahead)], 3);
  EXPECT_EQ(jobs.finished[std::size_t(TeJobKind::Ground)], 1);
  EXPECT_EQ(jobs.finished[std::size_t(TeJobKind::Block)], 1);
}

TEST(TeJobQueue, JobsMayComeAndGoWhileOneEnds) {
  TeJobQueue queue;
  std::vector<double> ended;
  const TeJob* victim = &queue.add(job(TeJobKind::Block, 3));
  queue.add(job(TeJobKind::Block, 1));
  queue.add(job(TeJobKind::Block, 2));
  queue.add(job(TeJobKind::Block, 4));
  queue.setFinished([&](TeJob& done, TeProgress) {
    ended.push_back(done.urgency().distance);
    if (ended.size() == 1) {
      queue.cancel(*victim);
      queue.add(job(TeJobKind::Block, 0.5));
      queue.add(job(TeJobKind::Ground, 7));
    }
  });
  TeAllowance all = TeAllowance::unlimited();
  queue.run(all);
  EXPECT_EQ(ended, (std::vector<double>{1, 7, 0.5, 2, 4}));
}

TEST(TeJobQueue, AJobMayCancelItselfAndAllOthersInItsStep) {
  TeJobQueue queue;
  int ended = 0;
  queue.setFinished([&](TeJob&, TeProgress) { ++ended; });
  auto self = job(TeJobKind::Block, 1, 5);
  self->m_onUnit = [&](TeCountingJob& job) {
    if (job.done() == 2)
      queue.clear();
  };
  queue.add(std::move(self));
  queue.add(job(TeJobKind::Block, 2));
  TeAllowance all = TeAllowance::unlimited();
  queue.run(all);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(ended, 0);
  TeStatistics::Jobs jobs;
  queue.count(jobs);
  EXPECT_EQ(jobs.cancelled[std::size_t(TeJobKind::Block)], 2);
}

TEST(TeJobQueue, CountsJobsByKindAndState) {
  TeJobQueue queue;
  queue.add(job(TeJobKind::Block, 1, 5));
  queue.add(job(TeJobKind::Block, 2, 5));
  auto failing = job(TeJobKind::Ground, 1);
  failing->m_fails = true;
  queue.add(std::move(failing));
  std::string reason;
  queue.setFinished([&](TeJob& ended, TeProgress progress) {
    if (progress == TeProgress::Failed)
      reason = ended.error().message;
  });
  TeAllowance two = TeAllowance::units(2);
  queue.run(two);
  TeStatistics::Jobs jobs;
  queue.count(jobs);
  const auto& block = jobs.now[std::size_t(TeJobKind::Block)];
  EXPECT_EQ(block[std::size_t(TeJobState::Blend)], 1);
  EXPECT_EQ(block[std::size_t(TeJobState::Waiting)], 1);
  EXPECT_EQ(jobs.started[std::size_t(TeJobKind::Block)], 1);
  EXPECT_EQ(jobs.started[std::size_t(TeJobKind::Ground)], 1);
  EXPECT_EQ(jobs.failed[std::size_t(TeJobKind::Ground)], 1);
  EXPECT_EQ(reason, "no luck");
}

TEST(TeJobQueue, AJobThatRunsOutOfMemoryFailsAlone) {
  TeJobQueue queue;
  auto greedy = job(TeJobKind::Block, 1, 3);
  greedy->m_onUnit = [](TeCountingJob&) { throw std::bad_alloc(); };
  queue.add(std::move(greedy));
  queue.add(job(TeJobKind::Block, 2));
  std::vector<std::string> ends;
  queue.setFinished([&](TeJob& ended, TeProgress progress) {
    ends.push_back(progress == TeProgress::Failed ? ended.failure().message : "done");
  });
  TeAllowance all = TeAllowance::unlimited();
  queue.run(all);
  EXPECT_EQ(ends, (std::vector<std::string>{"out of memory", "done"}));
}

TEST(TeJobQueue, AJobWithoutADistanceComesLast) {
  TeJobQueue queue;
  queue.add(job(TeJobKind::Block, double(NAN)));
  queue.add(job(TeJobKind::Block, 1e300));
  const std::vector<double> distances = order(queue);
  ASSERT_EQ(distances.size(), 2u);
  EXPECT_EQ(distances[0], 1e300);
}
