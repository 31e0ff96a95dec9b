#pragma once

#include "generators/TeGeneratorRegistry.h"
#include "tests/bench/TeBenchmarkReport.h"

#include <limits>
#include <string>

/// CPU microseconds of the longest unit of a job: what the shortest slice of it takes at most. The least of
/// 20 jobs, so that interrupts do not count.
inline double teLongestUnit(const TeHeightSource& source, const TeMapRequest& request) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 20; ++run) {
    const std::unique_ptr<TeHeightJob> job = source.start(request);
    double longest = 0;
    TeProgress progress = TeProgress::Working;
    while (progress == TeProgress::Working) {
      TeAllowance unit = TeAllowance::units(1);
      const double start = teThreadCpuSeconds();
      progress = job->step(unit);
      longest = std::max(longest, teThreadCpuSeconds() - start);
    }
    least = std::min(least, longest);
  }
  return least * 1e6;
}

/// Makes source maps of state.range(0) samples a side, a new key each time.
inline void teSourceBenchmark(benchmark::State& state, const std::string& generator) {
  const int side = int(state.range(0));
  const TeHeightSourcePtr source = TeGeneratorRegistry::instance().source(generator).value();
  const TeLattice lattice = TeLattice::create(side, 1).value();
  TeMapKey key;
  const TeBenchmarkWork work{std::int64_t(side) * side,
                             std::size_t(side) * std::size_t(side) * sizeof(float)};
  teBenchmark(state, work, [&] {
    ++key.x;
    benchmark::DoNotOptimize(source->generate(TeMapRequest::sourceMap(lattice, 1, key)).value().data());
  });
  if (side <= 257)
    state.counters["unit_us"] = teLongestUnit(*source, TeMapRequest::sourceMap(lattice, 1, key));
}

/// Evaluates every `state.range(0)`-th sample of every such row of a 65×65 map.
inline void tePointBenchmark(benchmark::State& state, const std::string& generator) {
  const TeHeightSourcePtr source = TeGeneratorRegistry::instance().source(generator).value();
  const TeLattice lattice = TeLattice::create(65, 1).value();
  std::vector<TeMapSample> samples;
  for (int row = 0; row < 65; row += int(state.range(0)))
    for (int column = 0; column < 65; column += int(state.range(0)))
      samples.push_back({column, row});
  std::vector<float> heights(samples.size());
  TeMapKey key;
  const TeBenchmarkWork work{std::int64_t(samples.size()), samples.size() * sizeof(float)};
  teBenchmark(state, work, [&] {
    ++key.x;
    const TeMapRequest request = TeMapRequest::sourceMap(lattice, 1, key);
    benchmark::DoNotOptimize(source->evaluate(request, samples.data(), samples.size(), heights.data()).ok());
  });
}
