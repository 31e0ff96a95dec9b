#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeRandom.h"
#include "generators/filters/TeBandGrid.h"
#include "tests/bench/TeBenchmarkReport.h"
#include "tests/bench/TeSourceBenchmark.h"

namespace {

TeHeightMap randomMap(int side) {
  TeHeightMap map = TeHeightMap::create(side, side).value();
  TeRandom random(1, 2, {3, 4});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map.at(x, y) = float(random.uniform(-100.0, 100.0));
  return map;
}

TeBenchmarkWork pair(const TeHeightMap& map) {
  return {std::int64_t(map.width()) * map.height(), map.bytes(), 4};
}

/// One pair of sweeps, there and back, along rows or columns.
void bandPair(benchmark::State& state, TeBandGrid::Axis axis) {
  const TeHeightMap map = randomMap(int(state.range(0)));
  TeBandGrid grid(map.width(), map.height());
  grid.load(map, 0, map.height());
  teBenchmark(state, pair(map), [&] {
    grid.begin(0.9f, 1, axis);
    while (grid.axis() == axis && grid.unit()) {
    }
    benchmark::ClobberMemory();
  });
}

/// The loop as the document states it.
void plainRows(benchmark::State& state) {
  TeHeightMap map = randomMap(int(state.range(0)));
  const float k = 0.9f;
  const float rest = 1.0f - k;
  teBenchmark(state, pair(map), [&] {
    for (int y = 0; y < map.height(); ++y) {
      float* h = map.row(y);
      for (int x = 1; x < map.width(); ++x)
        h[x] = h[x - 1] * rest + h[x] * k;
      for (int x = map.width() - 2; x >= 0; --x)
        h[x] = h[x + 1] * rest + h[x] * k;
    }
    benchmark::ClobberMemory();
  });
}

/// A whole job over a source that costs next to nothing.
void filterJob(benchmark::State& state, const char* filter) {
  const int side = int(state.range(0));
  const auto source = TeGeneratorRegistry::instance().source("function:z=x", {filter}).value();
  const TeMapRequest request = TeMapRequest::standalone(side, side, 1, 0).value();
  TeBenchmarkWork work{std::int64_t(side) * side, std::size_t(side) * std::size_t(side) * sizeof(float)};
  teBenchmark(state, work, [&] { benchmark::DoNotOptimize(source->generate(request).value().data()); });
  state.counters["unit_us"] = teLongestUnit(*source, request);
}

void bandRows(benchmark::State& state) { bandPair(state, TeBandGrid::Axis::Rows); }
void bandColumns(benchmark::State& state) { bandPair(state, TeBandGrid::Axis::Columns); }
void band5(benchmark::State& state) { filterJob(state, "band"); }
void matrix3(benchmark::State& state) { filterJob(state, "matrix:size=3"); }
void matrix5(benchmark::State& state) { filterJob(state, "matrix:size=5"); }

void matrix31(benchmark::State& state) { filterJob(state, "matrix:size=31"); }

void copyMap(benchmark::State& state) {
  const TeHeightMap source = randomMap(int(state.range(0)));
  TeHeightMap destination = source;
  teBenchmark(state, {std::int64_t(source.width()) * source.height(), source.bytes()}, [&] {
    benchmark::DoNotOptimize(destination.copy(source, source.bounds(), destination.bounds()).ok());
  });
}

void addMap(benchmark::State& state) {
  const TeHeightMap source = randomMap(int(state.range(0)));
  TeHeightMap destination = TeHeightMap::create(source.width(), source.height()).value();
  teBenchmark(state, {std::int64_t(source.width()) * source.height(), source.bytes()}, [&] {
    benchmark::DoNotOptimize(destination.add(source, source.bounds(), destination.bounds()).ok());
  });
}

} // namespace

BENCHMARK(bandRows)->Name("filter/band rows up+down")->Arg(65)->Arg(257)->Arg(1025)->Arg(4097);
BENCHMARK(bandColumns)->Name("filter/band columns up+down")->Arg(65)->Arg(257)->Arg(1025)->Arg(4097);
BENCHMARK(plainRows)->Name("filter/plain loop rows up+down")->Arg(65)->Arg(1025);
BENCHMARK(band5)->Name("filter/job of 5 band passes")->Arg(65)->Arg(1025);
BENCHMARK(matrix3)->Name("filter/job of matrix 3x3")->Arg(65)->Arg(1025);
BENCHMARK(matrix5)->Name("filter/job of matrix 5x5")->Arg(65)->Arg(1025);
BENCHMARK(matrix31)->Name("filter/job of matrix 31x31")->Arg(65);
BENCHMARK(copyMap)->Name("map/copy")->Arg(65)->Arg(1025);
BENCHMARK(addMap)->Name("map/add")->Arg(65)->Arg(1025);
