// What the texture of a clipmap costs: 513 × 513 samples of each of levels 9 to 12, moved, converted and
// uploaded, with all tiles in memory. CPU time of the drawing thread, with glFinish().

#include "bench/scene/benchContext.h"
#include "generators/base/TeAllowance.h"
#include "nodes/clipmap/TeClipmapTexture.h"
#include "tests/bench/clipmapPyramid.h"

#include <benchmark/benchmark.h>

namespace {

constexpr std::size_t kAllTiles = std::size_t(256) << 20;

/// `step`: samples of the finest level; 0: jumps.
void update(benchmark::State& state, TeClipFormat format) {
  if (!benchContext->makeCurrent())
    std::abort();
  const auto windows = ClipmapPyramid::windows(kAllTiles);
  TeClipmapTexture texture(benchContext->id(), format);
  ClipmapFlight flight(double(state.range(0)));
  const glm::dvec2 places[] = {{700, 700}, {3300, 3300}};
  int number = 0;
  const auto frame = [&] {
    const glm::dvec2 centre = state.range(0) > 0 ? flight.next() : places[number++ % 2];
    windows->update(centre, ClipmapPyramid::kTop, 0);
    if (!texture.update(*windows))
      std::abort();
    benchContext->gl().finish();
  };
  frame();
  frame();
  const std::int64_t before = texture.bytesUploaded();
  const double start = teThreadCpuSeconds();
  for (auto _ : state)
    frame();
  const double frames = double(std::max<std::int64_t>(1, state.iterations()));
  state.counters["cpu_us"] = 1e6 * (teThreadCpuSeconds() - start) / frames;
  state.counters["uploaded"] = double(texture.bytesUploaded() - before) / frames;
  texture.free();
}

} // namespace

BENCHMARK_CAPTURE(update, short, TeClipFormat::Short)
    ->Name("clipmap texture, short, move by n (0: jump)")
    ->Arg(1)
    ->Arg(16)
    ->Arg(0)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(update, half, TeClipFormat::Half)
    ->Name("clipmap texture, half, move by n (0: jump)")
    ->Arg(1)
    ->Arg(16)
    ->Arg(0)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(update, float, TeClipFormat::Float)
    ->Name("clipmap texture, float, move by n (0: jump)")
    ->Arg(1)
    ->Arg(16)
    ->Arg(0)
    ->Unit(benchmark::kMicrosecond);
