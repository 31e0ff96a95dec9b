// What GeoMipMapping and Chunked LOD cost: making them (CPU time, a sample and in plain passes over the
// samples), choosing a frame (a visited node, and against brute force, which tests boxes of patches one by
// one, in the same run), and making its triangles anew. Views: the flyover, each next frame of it in turn.
// Heights: midpoint displacement, 10 m cells, 2 km from the lowest to the highest.

#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/brute/TeBruteForce.h"
#include "nodes/lod/chunked/TeChunkedLod.h"
#include "nodes/lod/geomipmap/TeGeoMipMapping.h"
#include "tests/bench/timing.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

namespace {

constexpr int kFrames = 36;
constexpr int kStride = 20; ///< frames of the flyover, 10 degrees
constexpr double kSpacing = 10;
constexpr double kRelief = 2000;

TeLodFieldPtr mountains(int cells) {
  static std::map<int, TeLodFieldPtr> made;
  TeLodFieldPtr& field = made[cells];
  if (field)
    return field;
  const TeLattice lattice = TeLattice::create(cells + 1, 1).value();
  const TeHeightSourcePtr source = TeGeneratorRegistry::instance().source("midpoint").value();
  auto map = std::make_shared<const TeHeightMap>(
      source->generate(TeMapRequest::sourceMap(lattice, 2007, TeMapKey())).value());
  TeLodField::Placement placement;
  placement.spacing = kSpacing;
  const TeMapStatistics statistics = map->statistics();
  placement.heightScale = kRelief / (double(statistics.maximum) - double(statistics.minimum));
  field = TeLodField::create(map, placement).value();
  return field;
}

std::vector<TeLodView> views(const TeLodField& field) {
  TeFlyover flight;
  flight.cells = field.cells();
  flight.spacing = field.spacing();
  flight.heightScale = field.heightScale();
  flight.sample = [&](std::int32_t column, std::int32_t row) { return field.height(column, row); };
  std::vector<TeLodView> views;
  for (int frame = 0; frame < kFrames; frame++)
    views.push_back(flight.view(frame * kStride).lodView());
  return views;
}

using Create = std::unique_ptr<TeLodMethod> (*)(TeLodFieldPtr field, int cells);

std::unique_ptr<TeLodMethod> geoMip(TeLodFieldPtr field, int cells) {
  TeGeoMipMapping::Settings settings;
  settings.patchCells = cells;
  return std::move(TeGeoMipMapping::create(std::move(field), settings).value());
}

std::unique_ptr<TeLodMethod> chunked(TeLodFieldPtr field, int cells) {
  TeChunkedLod::Settings settings;
  settings.leafCells = cells;
  return std::move(TeChunkedLod::create(std::move(field), settings).value());
}

void prepare(benchmark::State& state, Create create) {
  const TeLodFieldPtr field = mountains(int(state.range(0)));
  const double pass =
      leastSeconds(5, [&] { benchmark::DoNotOptimize(field->heights().statistics().maximum); });
  double least = 1e9;
  for (auto _ : state) {
    const double seconds =
        leastSeconds(1, [&] { benchmark::DoNotOptimize(create(field, int(state.range(1))).get()); });
    state.SetIterationTime(seconds);
    least = std::min(least, seconds);
  }
  state.counters["ns_a_sample"] = 1e9 * least / (double(field->cells() + 1) * (field->cells() + 1));
  state.counters["passes"] = least / pass;
}

/// Nanoseconds a patch of brute force.
double bruteNanoseconds(const TeLodFieldPtr& field, const std::vector<TeLodView>& views) {
  TeBruteForce brute(field);
  double visited = 0;
  const double least = leastSeconds(5, [&] {
    visited = 0;
    for (const TeLodView& view : views) {
      brute.select(view, TeLodAccuracy());
      visited += double(brute.selection().visited);
    }
  });
  return 1e9 * least / visited;
}

void select(benchmark::State& state, Create create, bool geomorph) {
  const TeLodFieldPtr field = mountains(int(state.range(0)));
  const std::unique_ptr<TeLodMethod> method = create(field, int(state.range(1)));
  const std::vector<TeLodView> all = views(*field);
  TeLodAccuracy accuracy;
  accuracy.pixelError = double(state.range(2)) / 10;
  accuracy.geomorph = geomorph;
  double seconds = 0, visited = 0, triangles = 0, parts = 0;
  std::size_t frame = 0;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    method->select(all[frame], accuracy);
    const double passed = teThreadCpuSeconds() - start;
    state.SetIterationTime(passed);
    seconds += passed;
    visited += double(method->selection().visited);
    triangles += double(method->selection().triangles);
    parts += double(method->selection().parts.size());
    frame = (frame + 1) % all.size();
  }
  const double frames = double(std::max<std::int64_t>(1, state.iterations()));
  TeLodMesh mesh;
  const double making = leastSeconds(5, [&] {
    mesh.clear();
    method->appendMesh(mesh);
  });
  state.counters["visited"] = visited / frames;
  state.counters["parts"] = parts / frames;
  state.counters["triangles"] = triangles / frames;
  state.counters["ns_a_node"] = 1e9 * seconds / visited;
  state.counters["brutes"] = 1e9 * seconds / visited / bruteNanoseconds(field, all);
  state.counters["mesh_ns_a_triangle"] = 1e9 * making / double(mesh.triangles());
  state.counters["bytes_a_sample"] = method->bytesPerSample();
}

} // namespace

// Cells of the terrain and of a patch or leaf, a side; then the wanted error in tenths of a pixel. "passes":
// times a plain pass over the samples; "brutes": times what brute force needs for a patch.
BENCHMARK_CAPTURE(prepare, geomipmap, geoMip)
    ->Name("lod/prepare geomipmap")
    ->ArgsProduct({{1024, 4096}, {8, 16, 32}})
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(prepare, chunked, chunked)
    ->Name("lod/prepare chunked")
    ->ArgsProduct({{1024, 4096}, {16}})
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select, geomipmap, geoMip, false)
    ->Name("lod/select geomipmap")
    ->ArgsProduct({{1024, 4096}, {8, 16, 32}, {43}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(select, geomipmapMorph, geoMip, true)
    ->Name("lod/select geomipmap, morphing")
    ->Args({1024, 8, 43})
    ->Args({4096, 32, 43})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(select, chunked, chunked, false)
    ->Name("lod/select chunked")
    ->ArgsProduct({{1024, 4096}, {8, 16, 32}, {43}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(select, chunkedMorph, chunked, true)
    ->Name("lod/select chunked, morphing")
    ->ArgsProduct({{1024, 4096}, {16}, {43}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
