// RTIN: what the errors of all vertices cost, midpoint and exact, triangles for a wanted error in metres over
// the whole terrain, and selections on the flyover. TERRANE_BENCH_MAP names a square map of 16-bit samples
// (the peers' mpd_1025: 10 m cells, 0.03 m a unit); without it two waves of 1025² samples take its place.

#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/rtin/TeRtinLod.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace {

constexpr double kSpacing = 10;
constexpr double kHeightScale = 0.03;

TeHeightMap readMap() {
  const char* name = std::getenv("TERRANE_BENCH_MAP");
  std::ifstream file(name ? name : "", std::ios::binary);
  std::vector<unsigned char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const int side = bytes.empty() ? 1025 : int(std::lround(std::sqrt(double(bytes.size()) / 2)));
  TeHeightMap map = TeHeightMap::create(side, side).value();
  for (int row = 0; row < side; row++)
    for (int column = 0; column < side; column++) {
      const std::size_t at = 2 * (std::size_t(row) * std::size_t(side) + std::size_t(column));
      map.at(column, row) = bytes.empty()
                                ? float(20000 + 15000 * std::sin(column / 97.0) * std::cos(row / 71.0) +
                                        900 * std::sin(column / 7.0) * std::sin(row / 5.0))
                                : float(bytes[at] + 256 * bytes[at + 1]);
    }
  return map;
}

TeLodFieldPtr field() {
  static const TeLodFieldPtr made =
      TeLodField::create(std::make_shared<const TeHeightMap>(readMap()), {{0, 0, 0}, kSpacing, kHeightScale})
          .value();
  return made;
}

TeRtinError errorOf(std::int64_t number) { return number == 0 ? TeRtinError::Midpoint : TeRtinError::Exact; }

/// The least CPU seconds of some runs.
double leastSeconds(int runs, const std::function<void()>& work) {
  double least = 1e9;
  for (int run = 0; run < runs; run++) {
    const double start = teThreadCpuSeconds();
    work();
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return least;
}

/// Errors of all vertices. "midpoints": the time in that of midpoint errors in the same run, turn by turn.
void errors(benchmark::State& state) {
  const TeHeightMap& heights = field()->heights();
  double least = 1e9, midpoint = 1e9;
  for (auto _ : state) {
    midpoint =
        std::min(midpoint, leastSeconds(1, [&] {
                   benchmark::DoNotOptimize(TeRtinErrors::create(heights, TeRtinError::Midpoint).data());
                 }));
    const double seconds = leastSeconds(
        1, [&] { benchmark::DoNotOptimize(TeRtinErrors::create(heights, errorOf(state.range(0))).data()); });
    state.SetIterationTime(seconds);
    least = std::min(least, seconds);
  }
  state.counters["least_ms"] = 1e3 * least;
  state.counters["ns_a_sample"] = 1e9 * least / (double(heights.width()) * heights.width());
  state.counters["midpoints"] = least / midpoint;
}

/// Triangles for an error in units of the map over the whole terrain, and the true one.
void meshForError(benchmark::State& state) {
  TeRtinLod method(field(), errorOf(state.range(0)));
  TeLodAccuracy accuracy;
  accuracy.dial = double(state.range(1)) * kHeightScale;
  TeLodView view;
  view.eye = {0, 0, 1e6};
  double least = 1e9;
  for (auto _ : state) {
    const double seconds = leastSeconds(1, [&] { method.select(view, accuracy); });
    state.SetIterationTime(seconds);
    least = std::min(least, seconds);
  }
  TeLodMesh mesh;
  const double append = leastSeconds(5, [&] {
    mesh.clear();
    method.appendMesh(mesh);
  });
  TeScreenError error(field()->heights(), {0, 0, 0}, kSpacing, kHeightScale);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  const double triangles = double(method.selection().triangles);
  state.counters["triangles"] = triangles;
  state.counters["true_units"] = error.measure(view).worstMetres / kHeightScale;
  state.counters["least_ms"] = 1e3 * least;
  state.counters["ns_a_triangle"] = 1e9 * least / triangles;
  state.counters["append_ns"] = 1e9 * append / triangles;
}

/// Each next frame of the flyover in turn, by a wanted error in quarters of a pixel.
void flyover(benchmark::State& state) {
  TeRtinLod method(field(), errorOf(state.range(0)));
  TeFlyover flight;
  flight.cells = field()->cells();
  flight.spacing = kSpacing;
  flight.heightScale = kHeightScale;
  flight.sample = [](std::int32_t column, std::int32_t row) { return field()->height(column, row); };
  TeLodAccuracy accuracy;
  accuracy.pixelError = 0.25 * double(state.range(1));
  double seconds = 0, triangles = 0, visited = 0, append = 0, worst = 0, bound = 0;
  int frame = 0;
  TeLodMesh mesh;
  TeScreenError error(field()->heights(), {0, 0, 0}, kSpacing, kHeightScale);
  for (auto _ : state) {
    const TeLodView view = flight.view(8 * (frame % 90)).lodView();
    const double passed = leastSeconds(1, [&] { method.select(view, accuracy); });
    state.SetIterationTime(passed);
    seconds += passed;
    triangles += double(method.selection().triangles);
    visited += double(method.selection().visited);
    mesh.clear();
    append += leastSeconds(1, [&] { method.appendMesh(mesh); });
    if (frame % 30 == 0) {
      error.clear();
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
                  mesh.vertices[mesh.indices[i + 2]]);
      worst = std::max(worst, error.measure(view).worst);
    }
    bound = std::max(bound, method.selection().errorBound);
    frame++;
  }
  state.counters["triangles"] = triangles / frame;
  state.counters["visited"] = visited / frame;
  state.counters["ns_a_triangle"] = 1e9 * seconds / triangles;
  state.counters["append_ns"] = 1e9 * append / triangles;
  state.counters["worst_px"] = worst;
  state.counters["bound_px"] = bound;
}

} // namespace

// 0: midpoint errors, 1: exact ones.
BENCHMARK(errors)
    ->Name("lod/rtin/errors")
    ->Arg(0)
    ->Arg(1)
    ->UseManualTime()
    ->Iterations(21)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(meshForError)
    ->Name("lod/rtin/mesh_for_error")
    ->ArgNames({"exact", "units"})
    ->Args({0, 655})
    ->Args({1, 655})
    ->UseManualTime()
    ->Iterations(15)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(flyover)
    ->Name("lod/rtin/flyover")
    ->ArgNames({"exact", "quarter_px"})
    ->ArgsProduct({{0, 1}, {4, 16, 64}})
    ->UseManualTime()
    ->Iterations(90)
    ->Unit(benchmark::kMillisecond);
