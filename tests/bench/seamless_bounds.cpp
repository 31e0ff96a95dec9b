#include "nodes/lod/TeScreenError.h"
#include "nodes/seamless/TeSeamlessBounds.h"
#include "tests/bench/TeBenchmarkReport.h"

#include <cmath>

namespace {

TeHeightMap hills(int resolution) {
  TeHeightMap map = TeHeightMap::create(resolution + 1, resolution + 1).value();
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++)
      map.at(x, y) = std::round(float(20000 + 9000 * std::sin(x * 0.011) * std::cos(y * 0.007)));
  return map;
}

TeBenchmarkWork workOn(const TeHeightMap& map) {
  return {std::int64_t(map.width()) * map.height(), map.bytes(), 0, map.bytes()};
}

/// Exact errors of all sides: one interpolation a sample for each resolution, and the fans of the strips.
void seamlessBounds(benchmark::State& state) {
  const TeHeightMap map = hills(int(state.range(0)));
  const TeSeamlessLayout layout =
      TeSeamlessLayout::create(int(state.range(0)), int(state.range(1)), int(state.range(2))).value();
  teBenchmark(state, workOn(map),
              [&] { benchmark::DoNotOptimize(TeSeamlessBounds::create(layout, map).value().get()); });
}

/// What any pass over the samples costs.
void onePass(benchmark::State& state) {
  const TeHeightMap map = hills(int(state.range(0)));
  teBenchmark(state, workOn(map), [&] { benchmark::DoNotOptimize(map.statistics().maximum); });
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
  teBenchmark(state, workOn(map), [&] {
    error.clear();
    for (int y = 0; y < resolution; y += step)
      for (int x = 0; x < resolution; x += step) {
        error.add(vertex(x, y), vertex(x + step, y), vertex(x + step, y + step));
        error.add(vertex(x, y), vertex(x + step, y + step), vertex(x, y + step));
      }
    benchmark::DoNotOptimize(error.measure(TeLodView()).worst);
  });
}

BENCHMARK(onePass)->Name("samples/one_pass")->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);
BENCHMARK(seamlessBounds)
    ->Name("seamless/bounds")
    ->ArgNames({"resolution", "min", "levels"})
    ->Args({1024, 16, 3})
    ->Args({1024, 2, 9})
    ->Args({4096, 16, 3})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(screenError)->Name("lod/screen_error")->Arg(1024)->Unit(benchmark::kMillisecond);

} // namespace
