#include "engine/jobs/TeCountingJob.h"
#include "engine/jobs/TeJobQueue.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace {

struct Wanted {
  TeJobKind kind;
  TeUrgency urgency;
};

/// Few ranks and distances, so that most jobs are tied with others but for key and part.
std::vector<Wanted> tiedJobs() {
  std::vector<Wanted> jobs;
  for (std::int64_t y = -4; y < 4; ++y)
    for (std::int64_t x = -4; x < 4; ++x)
      for (int part = 0; part < 2; ++part) {
        const TePatchKey key{x, y, 0};
        jobs.push_back({TeJobKind((x + 4) % kTeJobKinds), {int(y & 1), double(x & 2), key, part}});
      }
  return jobs;
}

/// The order in which units were done, in ticks of some units, with a review that shuffles urgencies between.
std::vector<std::pair<TePatchKey, int>> orderOf(const std::vector<Wanted>& jobs, std::int64_t units) {
  TeJobQueue queue;
  std::vector<std::pair<TePatchKey, int>> order;
  for (const Wanted& wanted : jobs) {
    auto job = std::make_unique<TeCountingJob>(wanted.kind, wanted.urgency, 3);
    job->m_onUnit = [&](TeCountingJob& self) { order.emplace_back(self.urgency().key, self.urgency().part); };
    queue.add(std::move(job));
  }
  for (int tick = 0; !queue.empty(); ++tick) {
    if (tick % 5 == 4)
      queue.review([&](TeJob&, TeJobKind& kind, TeUrgency& urgency) {
        urgency.distance = double((urgency.key.y + tick) & 1);
        if (kind != TeJobKind::Ground && urgency.key.x == tick % 4)
          kind = TeJobKind::Ahead;
        return urgency.key.y != -(tick % 7);
      });
    TeAllowance allowance = TeAllowance::units(units);
    queue.run(allowance);
  }
  return order;
}

} // namespace

// Jobs that differ in nothing but their key are done in the same order, however they were put in.
TEST(HardCase, PriorityTiesEngine) {
  std::vector<Wanted> jobs = tiedJobs();
  TeRandom random(21, 21, {});
  int orders = 0;
  for (std::int64_t units : {1, 7, 50, 100000}) {
    const auto expected = orderOf(jobs, units);
    ASSERT_GT(expected.size(), jobs.size());
    for (int run = 0; run < 50; ++run, ++orders) {
      for (std::size_t i = jobs.size(); i > 1; --i)
        std::swap(jobs[i - 1], jobs[random.below(i)]);
      ASSERT_EQ(orderOf(jobs, units), expected) << "units " << units << ", run " << run;
    }
  }
  std::printf("PriorityTiesEngine: %d shuffled orders of %zu tied jobs, none done in another order\n", orders,
              jobs.size());
}
