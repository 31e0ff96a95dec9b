// What it costs to move the windows of a clipmap: 513 × 513 samples of each of levels 9 to 12 of a pyramid,
// against a plain copy of the bytes that are to be uploaded. Columns are copied sample by sample, and tiles
// that are not in memory are read; only a jump with all tiles there is like a plain copy.

#include "tests/bench/TeBenchmarkReport.h"
#include "tests/bench/clipmapPyramid.h"

namespace {

void measure(benchmark::State& state, std::size_t cacheBytes, double step) {
  ClipmapFlight flight(step);
  const auto windows = ClipmapPyramid::windows(cacheBytes);
  windows->update(flight.next(), ClipmapPyramid::kTop, 0);
  constexpr int kSample = 256;
  const std::int64_t before = windows->statistics().bytesUploaded;
  ClipmapFlight sample = flight;
  for (int i = 0; i < kSample; i++)
    windows->update(sample.next(), ClipmapPyramid::kTop, 0);
  TeBenchmarkWork work;
  work.copyBytes = std::size_t((windows->statistics().bytesUploaded - before) / kSample);
  windows->update(flight.next(), ClipmapPyramid::kTop, 0);
  teBenchmark(state, work, [&] {
    windows->update(flight.next(), ClipmapPyramid::kTop, 0);
    windows->clearUploads();
  });
  state.counters["uploaded"] = double(work.copyBytes);
}

void moves(benchmark::State& state) {
  measure(state, TePyramidTiles::kDefaultCacheBytes, double(state.range(0)));
}

void movesInMemory(benchmark::State& state) {
  measure(state, std::size_t(256) << 20, double(state.range(0)));
}

void jump(benchmark::State& state) {
  const bool isInMemory = state.range(0) > 100;
  const auto windows = ClipmapPyramid::windows(std::size_t(state.range(0)) << 20);
  const glm::dvec2 places[] = {{700, 700}, {3300, 3300}};
  int number = 0;
  TeBenchmarkWork work;
  work.copyBytes = 3 * windows->imageBytes();
  work.targetCopies = isInMemory ? 3 : 0;
  teBenchmark(state, work, [&] {
    windows->update(places[number++ % 2], ClipmapPyramid::kTop, 0);
    windows->clearUploads();
  });
  state.counters["uploaded"] = double(work.copyBytes);
}

} // namespace

BENCHMARK(moves)->Name("clipmap/move by n samples")->Arg(1)->Arg(16)->Unit(benchmark::kMicrosecond);
BENCHMARK(movesInMemory)
    ->Name("clipmap/move by n samples, all tiles in memory")
    ->Arg(1)
    ->Arg(16)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(jump)->Name("clipmap/jump, n MB of tiles")->Arg(1)->Arg(256)->Unit(benchmark::kMicrosecond);
