// RTIN: what the errors of all vertices cost, midpoint and exact, triangles for a wanted error in metres over
// the whole terrain, and selections on the flyover. Terrain: rtinField.h.

#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/rtin/TeRtinLod.h"
#include "tests/bench/rtinField.h"
#include "tests/bench/timing.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace {

TeRtinError errorOf(std::int64_t number) { return number == 0 ? TeRtinError::Midpoint : TeRtinError::Exact; }

/// Errors of all vertices. "midpoints": the time in that of midpoint errors in the same run, turn by turn.
void errors(benchmark::State& state) {
  const TeHeightMap& heights = rtinField()->heights();
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
  TeRtinLod method(rtinField(), errorOf(state.range(0)));
  TeLodAccuracy accuracy;
  accuracy.dial = double(state.range(1)) * rtinField()->heightScale();
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
  TeScreenError error(rtinField()->heights(), {0, 0, 0}, rtinField()->spacing(), rtinField()->heightScale());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  const double triangles = double(method.selection().triangles);
  state.counters["triangles"] = triangles;
  state.counters["true_units"] = error.measure(view).worstMetres / rtinField()->heightScale();
  state.counters["least_ms"] = 1e3 * least;
  state.counters["ns_a_triangle"] = 1e9 * least / triangles;
  state.counters["append_ns"] = 1e9 * append / triangles;
}

/// Each next frame of the flyover in turn, by a wanted error in quarters of a pixel.
void flyover(benchmark::State& state) {
  TeRtinLod method(rtinField(), errorOf(state.range(0)));
  TeFlyover flight;
  flight.cells = rtinField()->cells();
  flight.spacing = rtinField()->spacing();
  flight.heightScale = rtinField()->heightScale();
  flight.sample = [](std::int32_t column, std::int32_t row) { return rtinField()->height(column, row); };
  TeLodAccuracy accuracy;
  accuracy.pixelError = 0.25 * double(state.range(1));
  double seconds = 0, triangles = 0, visited = 0, append = 0, worst = 0, bound = 0;
  int frame = 0;
  TeLodMesh mesh;
  TeScreenError error(rtinField()->heights(), {0, 0, 0}, rtinField()->spacing(), rtinField()->heightScale());
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
