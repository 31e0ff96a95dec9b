// A tick of many objects (contract 10: one that rests costs nothing).

#include "engine/objects/TeAircraft.h"
#include "engine/objects/TeObjects.h"
#include "tests/patchdb/TeTestWorlds.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace {

enum class State { Resting, Moving, Flying };

/// `per_object`: of a tick of one step. Target for resting ones: a tick costs the same however many there
/// are.
void tickOf(benchmark::State& state, State what) {
  const auto terrain = teSampleWorld([](std::int64_t, std::int64_t) { return 0.0f; }, 33);
  TeObjects objects;
  const int count = int(state.range(0));
  for (int i = 0; i < count; ++i) {
    const std::string name = std::to_string(i);
    std::unique_ptr<TeObject> object =
        what == State::Flying ? std::make_unique<TeAircraft>(name) : std::make_unique<TeObject>(name);
    (void)object->setPosition({100.0 * i, 0, 100});
    if (what != State::Resting)
      (void)object->setVelocity({1, 2, 0});
    (void)objects.add(std::move(object));
  }
  (void)objects.update(0.02, *terrain); // lets those that rest fall asleep
  std::int64_t updates = 0;
  for (auto _ : state) {
    const auto tick = objects.update(0.02, *terrain);
    updates += tick->updates;
  }
  state.counters["updates"] = benchmark::Counter(double(updates), benchmark::Counter::kAvgIterations);
  state.counters["per_object"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(tickOf, resting, State::Resting)->Arg(1)->Arg(100)->Arg(10'000);
BENCHMARK_CAPTURE(tickOf, moving, State::Moving)->Arg(1)->Arg(100)->Arg(10'000);
BENCHMARK_CAPTURE(tickOf, aircraft, State::Flying)->Arg(1)->Arg(100)->Arg(10'000);

} // namespace
