// What an update of the adaptive quadtree costs, by the size of the data: the same flight over trees that are
// equally dense around it, of 1k² (dense), 4k² and 16k² samples (sparse far away), in one run. CPU time a
// frame under smooth motion, with and without emitting the triangles, a displayed triangle, and as ratios to
// a plain pass that writes as many triangles.

#include "generators/base/TeAllowance.h"
#include "generators/base/TeHash.h"
#include "nodes/lod/TePerspectiveView.h"
#include "nodes/lod/quadtree/TeQuadtreeMesh.h"
#include "tests/bench/timing.h"

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <map>

namespace {

constexpr int kFrames = 120;
constexpr double kSpacing = 10;
constexpr double kSpeed = 10; ///< metres a frame

/// Octaves of smooth noise, the same at every level of sampling.
float hills(std::int64_t column, std::int64_t row) {
  double height = 0, size = 500;
  for (int octave = 10; octave >= 0; octave--, size *= 0.55) {
    const std::int64_t cell = std::int64_t(1) << octave;
    const std::int64_t x = column >> octave, y = row >> octave;
    const double u = double(column & (cell - 1)) / double(cell), v = double(row & (cell - 1)) / double(cell);
    const auto at = [&](std::int64_t i, std::int64_t j) {
      const std::uint64_t place = std::uint64_t(j) << 32 ^ std::uint64_t(i) ^ std::uint64_t(octave) << 60;
      return double(teMix(place) >> 11) * 0x1p-52 - 1;
    };
    const double s = u * u * (3 - 2 * u), t = v * v * (3 - 2 * v);
    height += size * ((at(x, y) * (1 - s) + at(x + 1, y) * s) * (1 - t) +
                      (at(x, y + 1) * (1 - s) + at(x + 1, y + 1) * s) * t);
  }
  return float(height);
}

/// Rings around the middle: 1025² samples one, two, four … apart. The first is all there is of 1k².
const TeQuadtree& tree(int sideLog) {
  static std::map<int, TeQuadtree> made;
  const auto found = made.find(sideLog);
  if (found != made.end())
    return found->second;
  const std::int64_t side = std::int64_t(1) << sideLog;
  const auto sample = [&](std::int64_t x, std::int64_t y) {
    return hills(x - side / 2 + (1 << 20), y - side / 2 + (1 << 20));
  };
  TeQuadtree tree =
      TeQuadtree::create(sideLog, {sample(side, side), sample(0, side), sample(0, 0), sample(side, 0)})
          .value();
  for (int level = sideLog - 10; level >= 0; level--) {
    TeHeightMap map = TeHeightMap::create(1025, 1025).value();
    const std::int64_t corner = side / 2 - (512 << level);
    for (int row = 0; row <= 1024; row++)
      for (int column = 0; column <= 1024; column++)
        map.at(column, row) =
            sample(corner + (std::int64_t(column) << level), corner + (std::int64_t(row) << level));
    if (!tree.insert(map, std::int32_t(corner), std::int32_t(corner), level))
      std::abort();
  }
  return made.emplace(sideLog, std::move(tree)).first->second;
}

TeLodView view(int sideLog, int frame) {
  const double middle = std::ldexp(kSpacing, sideLog - 1);
  TePerspectiveView view;
  view.eye = {middle - 600 + kSpeed * frame, middle - 500, 1200};
  view.forward = glm::normalize(glm::dvec3(1, 0.3, -0.25));
  view.farDistance = 5000; // all of it over the dense part
  return view.lodView();
}

void flight(benchmark::State& state, const TeQuadtreeMesh::Wish& wish) {
  const int sideLog = int(state.range(0));
  const TeQuadtree& data = tree(sideLog);
  TeQuadtreeMesh mesh(data, TeLodField::Placement{{}, kSpacing, 1});
  TeLodMesh drawn;
  std::vector<double> updates, wholes;
  double triangles = 0, visited = 0, changes = 0;
  int frame = 0;
  mesh.update(view(sideLog, 0), wish);
  mesh.append(drawn);
  for (auto _ : state) {
    const TeLodView seen = view(sideLog, frame);
    const double start = teThreadCpuSeconds();
    const TeQuadtreeMesh::Result& result = mesh.update(seen, wish);
    const double updated = teThreadCpuSeconds();
    drawn.clear();
    mesh.append(drawn);
    const double appended = teThreadCpuSeconds();
    state.SetIterationTime(appended - start);
    updates.push_back(updated - start);
    wholes.push_back(appended - start);
    triangles += double(result.triangles);
    visited += double(result.visited);
    changes += double(result.enabled + result.disabled);
    frame = (frame + 1) % kFrames;
  }
  const double frames = double(updates.size());
  const double update = median(updates), whole = median(wholes);
  state.counters["data_squares"] = double(data.squareCount());
  state.counters["data_MB"] = double(data.bytes()) / 1e6;
  state.counters["mesh_MB"] = double(mesh.bytes()) / 1e6;
  state.counters["triangles"] = triangles / frames;
  state.counters["visited"] = visited / frames;
  state.counters["changes"] = changes / frames;
  state.counters["update_us"] = 1e6 * update;
  state.counters["update_ns_a_triangle"] = 1e9 * update * frames / triangles;
  state.counters["ns_a_triangle"] = 1e9 * whole * frames / triangles;
  const double plain = plainWriting(drawn);
  state.counters["plain_ns_a_triangle"] = plain;
  state.counters["ratio"] = 1e9 * whole * frames / triangles / plain;
}

void quadtreeByPixelError(benchmark::State& state) {
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = double(state.range(1));
  flight(state, wish);
}
void quadtreeByThreshold(benchmark::State& state) {
  TeQuadtreeMesh::Wish wish;
  wish.threshold = double(state.range(1));
  flight(state, wish);
}
void quadtreeMorphed(benchmark::State& state) {
  TeQuadtreeMesh::Wish wish;
  wish.pixelError = double(state.range(1));
  wish.geomorph = true;
  flight(state, wish);
}

/// A dense tree from a map: nanoseconds a sample.
void quadtreeBuilding(benchmark::State& state) {
  const int side = int(state.range(0)) + 1;
  TeHeightMap map = TeHeightMap::create(side, side).value();
  for (int row = 0; row < side; row++)
    for (int column = 0; column < side; column++)
      map.at(column, row) = hills(column, row);
  double seconds = 0;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    const TeQuadtree tree = TeQuadtree::create(map).value();
    benchmark::DoNotOptimize(tree.squareCount());
    const double passed = teThreadCpuSeconds() - start;
    state.SetIterationTime(passed);
    seconds += passed;
  }
  state.counters["ns_a_sample"] = 1e9 * seconds / double(state.iterations()) / double(side) / double(side);
}

/// Procedural detail around a viewer on the same flight: 1 km² of coarse data, squares down to 0.6 m.
void quadtreeDetail(benchmark::State& state) {
  TeQuadtree data =
      TeQuadtree::create(17, {0, 0, 0, 0}, std::make_shared<const TeFractalDetail>(1, 0.02, 1.8)).value();
  const double reach = double(state.range(0));
  double made = 0, dropped = 0, seconds = 0;
  double x = 40000;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    const TeQuadtree::DetailChange change = data.detailAround(x, 50000, reach);
    const double passed = teThreadCpuSeconds() - start;
    state.SetIterationTime(passed);
    seconds += passed;
    made += double(change.made);
    dropped += double(change.dropped);
    x = x < 60000 ? x + 2 : 40000;
  }
  state.counters["squares"] = double(data.squareCount());
  state.counters["made"] = made / double(state.iterations());
  state.counters["dropped"] = dropped / double(state.iterations());
}

} // namespace

// log2 of the side in samples; wanted pixels, or the document's threshold.
BENCHMARK(quadtreeByPixelError)
    ->ArgsProduct({{10, 12, 14}, {1, 4}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(quadtreeByThreshold)
    ->ArgsProduct({{10, 12, 14}, {200}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(quadtreeMorphed)->ArgsProduct({{10, 14}, {4}})->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(quadtreeBuilding)->Arg(1024)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(quadtreeDetail)->Arg(4)->Arg(12)->UseManualTime()->Unit(benchmark::kMicrosecond);
