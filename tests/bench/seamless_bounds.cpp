#include "nodes/lod/TeScreenError.h"
#include "nodes/seamless/TeSeamlessBounds.h"
#include "tests/bench/TeBenchmarkReport.h"
#include "tests/bench/timing.h"

#include <algorithm>
#include <cmath>

namespace {

TeHeightMap hills(int resolution) {
  TeHeightMap map = TeHeightMap::create(resolution + 1, resolution + 1).value();
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++)
      map.at(x, y) = std::round(float(20000 + 9000 * std::sin(x * 0.011) * std::cos(y * 0.007)));
  return map;
}

/// CPU seconds of what any pass over the samples costs: their minimum, maximum and mean.
double passSeconds(const TeHeightMap& map) {
  return leastSeconds(5, [&] { benchmark::DoNotOptimize(map.statistics().maximum); });
}

/// Runs `work`, which goes over all samples, and prints its time in passes too, and the aim for it.
template <class Work>
void overSamples(benchmark::State& state, const TeHeightMap& map, double targetMilliseconds, Work work) {
  const double start = teThreadCpuSeconds();
  for (auto _ : state)
    work();
  const double seconds =
      (teThreadCpuSeconds() - start) / double(std::max<std::int64_t>(1, state.iterations()));
  state.counters["ns_a_sample"] = seconds * 1e9 / (double(map.width()) * map.height());
  state.counters["passes"] = seconds / passSeconds(map);
  state.counters["target_ms"] = targetMilliseconds;
}

/// Exact errors of all sides: one interpolation a sample for each resolution, and the fans of the strips.
void seamlessBounds(benchmark::State& state) {
  const int resolution = int(state.range(0));
  const TeHeightMap map = hills(resolution);
  const TeSeamlessLayout layout =
      TeSeamlessLayout::create(resolution, int(state.range(1)), int(state.range(2))).value();
  overSamples(state, map, resolution <= 1024 ? 200 : 2000,
              [&] { benchmark::DoNotOptimize(TeSeamlessBounds::create(layout, map).value().get()); });
}

/// Triangles of cells of 4 samples against all samples.
void screenError(benchmark::State& state) {
  const int resolution = int(state.range(0));
  const int step = 4;
  const TeHeightMap map = hills(resolution);
  TeScreenError error(map, {0, 0, 0}, 10, 0.03);
  const auto vertex = [&](int column, int row) {
    return TeScreenError::Vertex{column, row, map.at(column, row)};
  };
  overSamples(state, map, 30, [&] {
    error.clear();
    for (int y = 0; y < resolution; y += step)
      for (int x = 0; x < resolution; x += step) {
        error.add(vertex(x, y), vertex(x + step, y), vertex(x + step, y + step));
        error.add(vertex(x, y), vertex(x + step, y + step), vertex(x, y + step));
      }
    benchmark::DoNotOptimize(error.measure(TeLodView()).worst);
  });
}

BENCHMARK(seamlessBounds)
    ->Name("seamless/bounds")
    ->ArgNames({"resolution", "min", "levels"})
    ->Args({1024, 16, 3})
    ->Args({1024, 2, 9})
    ->Args({4096, 16, 3})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(screenError)->Name("lod/screen_error")->Arg(1024)->Unit(benchmark::kMillisecond);

} // namespace
