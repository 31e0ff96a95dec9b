#include "generators/faults/TeFaultFormation.h"
#include "tests/bench/TeSourceBenchmark.h"

namespace {

using Formation = std::shared_ptr<const TeFaultFormation>;

Formation formation(const char* profile) {
  TeFaultParameters parameters;
  parameters.profile = profile;
  return TeFaultFormation::create(parameters).value();
}

/// The document's loop: a side test per sample and fault; sums in 32 bits, which is all that this one needs.
void plainLoop(const TeFaultFormation& source, const TeMapRequest& request, std::vector<std::int32_t>& sums) {
  const TeRandom random = source.random(request);
  std::fill(sums.begin(), sums.end(), 0);
  for (int f = 0; f < source.faults(); ++f) {
    const TeFaultLine line = source.line(request, random, f);
    const std::int64_t dx = line.bx - line.ax;
    const std::int64_t dy = line.by - line.ay;
    const std::int32_t amplitude = std::int32_t(source.amplitude(f));
    std::int32_t* sum = sums.data();
    for (int r = 0; r < request.rows; ++r)
      for (int c = 0; c < request.columns; ++c, ++sum)
        if (dx * (256 * std::int64_t(r) + 128 - line.ay) - dy * (256 * std::int64_t(c) + 128 - line.ax) > 0)
          *sum += amplitude;
  }
}

/// The same with the ramp evaluated in every sample.
void plainSmoothLoop(const TeFaultFormation& source, const TeMapRequest& request,
                     std::vector<std::int64_t>& sums) {
  const TeRandom random = source.random(request);
  std::fill(sums.begin(), sums.end(), 0);
  for (int f = 0; f < source.faults(); ++f) {
    const TeFaultPlane plane = source.plane(request, random, f);
    std::int64_t* sum = sums.data();
    for (int r = 0; r < request.rows; ++r)
      for (int c = 0; c < request.columns; ++c, ++sum)
        *sum += plane.smoothHeight(plane.value(c, r));
  }
}

/// CPU seconds of a call: the median of 9.
template <class Work> double seconds(Work work) {
  std::vector<double> runs;
  for (int run = 0; run < 9; ++run) {
    const double start = teThreadCpuSeconds();
    work();
    benchmark::ClobberMemory();
    runs.push_back(teThreadCpuSeconds() - start);
  }
  std::nth_element(runs.begin(), runs.begin() + 4, runs.end());
  return runs[4];
}

/// Also the ratio to the plain loop in the same run ("times_faster").
void map(benchmark::State& state, const char* profile) {
  teSourceBenchmark(state, std::string("faults:profile=") + profile);
  const int side = int(state.range(0));
  const Formation source = formation(profile);
  TeMapRequest request = TeMapRequest::standalone(side, side, 1, 1).value();
  const std::size_t samples = std::size_t(side) * std::size_t(side);
  std::vector<std::int32_t> steps(samples);
  std::vector<std::int64_t> ramps(samples);
  const double plain = seconds([&] {
    ++request.key.x;
    if (source->isSmooth())
      plainSmoothLoop(*source, request, ramps);
    else
      plainLoop(*source, request, steps);
  });
  const double ours = seconds([&] {
    ++request.key.x;
    benchmark::DoNotOptimize(source->generate(request).value().data());
  });
  state.counters["plain_us"] = plain * 1e6;
  state.counters["times_faster"] = plain / ours;
  if (!source->isSmooth())
    state.counters["target_faster"] = 10;
}

void step(benchmark::State& state) { map(state, "step"); }
void smooth(benchmark::State& state) { map(state, "smooth"); }
void stepPoints(benchmark::State& state) { tePointBenchmark(state, "faults"); }
void smoothPoints(benchmark::State& state) { tePointBenchmark(state, "faults:profile=smooth"); }

} // namespace

BENCHMARK(step)->Name("faults/map of 150 steps")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(smooth)->Name("faults/map of 150 ramps")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(stepPoints)->Name("faults/every n-th sample, steps")->Arg(1)->Arg(2)->Arg(8)->Arg(64);
BENCHMARK(smoothPoints)->Name("faults/every n-th sample, ramps")->Arg(1)->Arg(2)->Arg(8)->Arg(64);
