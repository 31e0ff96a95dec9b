#include "engine/jobs/TeJobQueue.h"
#include "generators/base/TeRandom.h"
#include "patchdb/TeKeySet.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

/// Units that do nothing.
class EmptyJob final : public TeJob {
public:
  EmptyJob(TeJobKind kind, const TeUrgency& urgency) : TeJob(kind, urgency) {}
  TeProgress step(TeAllowance& allowance) override {
    while (allowance.spend()) {
    }
    return TeProgress::Working;
  }
  TeJobState state() const override { return TeJobState::SourceMaps; }
  bool blocked() const override { return m_blocked; }
  const TeError& error() const override { return m_error; }

  bool m_blocked = false;

private:
  TeError m_error;
};

/// A block of patches, the nearest first.
void fill(TeJobQueue& queue, int jobs) {
  const int side = int(std::sqrt(double(jobs)));
  for (int i = 0; i < jobs; ++i) {
    const TePatchKey key{i % side - side / 2, i / side - side / 2, 0};
    const TeJobKind kind = i % 4 == 3 ? TeJobKind::Ahead : TeJobKind::Block;
    queue.add(std::make_unique<EmptyJob>(kind, TeUrgency{0, double(key.x * key.x + key.y * key.y), key}));
  }
}

/// A review as an object moves from patch to patch: other distances, another order.
void review(benchmark::State& state) {
  TeJobQueue queue;
  const int jobs = int(state.range(0));
  fill(queue, jobs);
  std::int64_t at = 0;
  for (auto _ : state) {
    ++at;
    const double x = double(at % 16), y = double(at % 5);
    queue.review([x, y](TeJob&, TeJobKind&, TeUrgency& urgency) {
      const double dx = double(urgency.key.x) - x, dy = double(urgency.key.y) - y;
      urgency.distance = dx * dx + dy * dy;
      return true;
    });
  }
  state.counters["ns/job"] = benchmark::Counter(double(state.iterations()) * jobs,
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["target_us"] = 0.1 * jobs;
}

/// What the queue adds to a unit if each tick holds only one.
void oneUnit(benchmark::State& state) {
  TeJobQueue queue;
  fill(queue, int(state.range(0)));
  for (auto _ : state) {
    TeAllowance allowance = TeAllowance::units(1);
    queue.run(allowance);
  }
  state.counters["target_ns"] = 200;
}

/// A unit of many of one slice, with the clock of the thread read after each.
void timedUnits(benchmark::State& state) {
  TeJobQueue queue;
  fill(queue, 1000);
  std::int64_t units = 0;
  for (auto _ : state) {
    TeAllowance allowance = TeAllowance::seconds(0.001);
    queue.run(allowance);
    units += allowance.unitsSpent();
  }
  state.counters["ns/unit"] =
      benchmark::Counter(double(units), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["target_ns"] = 1000;
}

/// A tick in which all jobs wait for workers.
void allBlocked(benchmark::State& state) {
  TeJobQueue queue;
  fill(queue, int(state.range(0)));
  queue.review([](TeJob& job, TeJobKind&, TeUrgency&) {
    static_cast<EmptyJob&>(job).m_blocked = true;
    return true;
  });
  for (auto _ : state) {
    TeAllowance allowance = TeAllowance::units(1);
    benchmark::DoNotOptimize(queue.run(allowance));
  }
  state.counters["target_us"] = 0.02 * double(state.range(0));
}

/// Adding and cancelling a job in a full queue.
void addAndCancel(benchmark::State& state) {
  TeJobQueue queue;
  fill(queue, int(state.range(0)));
  TeRandom random(3, 4, {});
  for (auto _ : state) {
    const TePatchKey key{std::int64_t(random.below(32)), 100, 0};
    const TeUrgency urgency{0, double(random.below(500)), key};
    const TeJob& job = queue.add(std::make_unique<EmptyJob>(TeJobKind::Block, urgency));
    queue.cancel(job);
  }
  state.counters["target_us"] = 5;
}

/// Remembering the maps of a straight flight.
void rememberKeys(benchmark::State& state) {
  TeKeySet keys;
  std::int64_t x = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(keys.insert(x >> 2, x & 3));
    ++x;
  }
  state.counters["bytes/key"] = double(keys.bytes()) / double(keys.size());
}

} // namespace

BENCHMARK(review)->Name("jobs/review")->Arg(100)->Arg(1000)->Arg(5000);
BENCHMARK(oneUnit)->Name("jobs/oneUnit")->Arg(1)->Arg(1000);
BENCHMARK(timedUnits)->Name("jobs/timedUnits");
BENCHMARK(allBlocked)->Name("jobs/allBlocked")->Arg(1000);
BENCHMARK(addAndCancel)->Name("jobs/addAndCancel")->Arg(1000);
BENCHMARK(rememberKeys)->Name("jobs/rememberKeys");
