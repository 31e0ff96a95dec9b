// What choosing the patches of a frame costs: Seamless Patches by precision and by screen error, in CPU time
// a frame and a visited patch, against a plain traversal of the same tree in the same run, and whether it
// grows with the terrain. Views: the flyover, each next frame of it in turn. Heights: two waves; precision is
// measured with no more than their range.

#include "apps/terrane-accuracy/TePlainTraversal.h"
#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeFlyover.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessSelector.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <map>

namespace {

constexpr int kFrames = 90;
constexpr double kSpacing = 10;
constexpr double kAim = 0.1; ///< milliseconds a frame

float waves(std::int32_t column, std::int32_t row) {
  return float(600 * std::sin(column / 97.0) * std::cos(row / 71.0) +
               40 * std::sin(column / 7.0) * std::sin(row / 5.0));
}

const std::vector<TeLodView>& views(int cells) {
  static std::map<int, std::vector<TeLodView>> made;
  std::vector<TeLodView>& all = made[cells];
  if (!all.empty())
    return all;
  TeFlyover flight;
  flight.cells = cells;
  flight.spacing = kSpacing;
  flight.sample = waves;
  for (int frame = 0; frame < kFrames; frame++)
    all.push_back(flight.view(frame * 8).lodView());
  return all;
}

std::shared_ptr<const TeSeamlessBounds> bounds(const TeSeamlessLayout& layout) {
  static std::map<int, std::shared_ptr<const TeSeamlessBounds>> made;
  std::shared_ptr<const TeSeamlessBounds>& result = made[layout.resolution()];
  if (result)
    return result;
  const int side = layout.resolution() + 1;
  TeHeightMap map = TeHeightMap::create(side, side).value();
  for (int row = 0; row < side; row++)
    for (int column = 0; column < side; column++)
      map.at(column, row) = waves(column, row);
  result = TeSeamlessBounds::create(layout, map).value();
  return result;
}

/// Nanoseconds a patch of a plain traversal of the same tree, and how many it visits a frame.
struct Plain {
  double nanoseconds = 0;
  double visited = 0;
};

Plain plainTraversal(const TeSeamlessSelector& selector, const TeSeamlessPlacement& placement,
                     const std::vector<TeLodView>& views, double precision) {
  TePlainTraversal traversal(selector.layout(), selector.bounds(), placement);
  double least = 1e9;
  double visited = 0;
  for (int run = 0; run < 5; run++) {
    visited = 0;
    const double start = teThreadCpuSeconds();
    for (const TeLodView& view : views) {
      traversal.run(view, precision);
      visited += double(traversal.visited());
    }
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return {1e9 * least / visited, visited / double(views.size())};
}

void selection(benchmark::State& state, bool byError) {
  const int cells = int(state.range(0));
  const TeSeamlessLayout layout = *TeSeamlessLayout::create(cells, 16, 3);
  const std::vector<TeLodView>& all = views(cells);
  TeSeamlessPlacement placement;
  placement.spacing = kSpacing;
  placement.range = {-640, 640};
  const TeSeamlessSelector selector(layout, byError ? bounds(layout) : nullptr);
  const TeSeamlessParts parts(layout);
  TeSeamlessAccuracy accuracy;
  (byError ? accuracy.pixelError : accuracy.precision) = double(state.range(1));
  TeSeamlessSelection chosen;
  TeSeamlessLists lists;
  double seconds = 0, visited = 0, drawn = 0, triangles = 0;
  std::size_t frame = 0;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    selector.select(all[frame], placement, accuracy, nullptr, chosen);
    lists.build(chosen, layout, parts);
    const double passed = teThreadCpuSeconds() - start;
    state.SetIterationTime(passed);
    seconds += passed;
    visited += double(chosen.traversed);
    drawn += double(chosen.patches.size());
    triangles += double(chosen.triangles);
    frame = (frame + 1) % all.size();
  }
  const double frames = double(std::max<std::int64_t>(1, state.iterations()));
  state.counters["visited"] = visited / frames;
  state.counters["drawn"] = drawn / frames;
  state.counters["triangles"] = triangles / frames;
  state.counters["ns_a_patch"] = 1e9 * seconds / visited;
  const Plain plain = plainTraversal(selector, placement, all, 2);
  state.counters["plain_ns_a_patch"] = plain.nanoseconds;
  state.counters["ratio"] = 1e9 * seconds / visited / plain.nanoseconds;
  state.counters["aims"] = 1e3 * seconds / frames / kAim;
}

void byPrecision(benchmark::State& state) { selection(state, false); }
void byPixelError(benchmark::State& state) { selection(state, true); }

} // namespace

// Cells a side, then the document's precision or the wanted error in pixels. "aims": times the 0.1 ms that a
// frame may take.
BENCHMARK(byPrecision)
    ->ArgsProduct({{4096, 16384}, {1, 2, 4}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(byPixelError)->ArgsProduct({{1024, 4096}, {1, 4}})->UseManualTime()->Unit(benchmark::kMicrosecond);
