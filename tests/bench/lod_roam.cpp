// What a frame of ROAM on a triangle quadtree costs: choosing and writing the triangles, under smooth motion
// and on the flyover, in CPU time a frame and a triangle; against the aims, a plain pass that writes as many
// triangles in the same run, and the figures of document 000 (3,000 triangles: 32 ms a frame; 6,000: 12
// frames a second; 0.8 splits and merges a frame). Over a map of TERRANE_BENCH_MAP (1025 × 1025 unsigned 16
// bit samples, row 0 in the south; 10 m apart, 0.03 m a unit), else over octaves of noise.

#include "generators/base/TeAllowance.h"
#include "generators/base/TeHash.h"
#include "nodes/lod/TeFlyover.h"
#include "nodes/lod/roam/TeRoamLod.h"
#include "tests/bench/timing.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace {

constexpr int kCells = 1024;
constexpr int kFrames = 240;

float noise(int column, int row) {
  double height = 0, size = 30000;
  for (int octave = 9; octave >= 0; octave--, size *= 0.55) {
    const int cell = 1 << octave, x = column >> octave, y = row >> octave;
    const double u = double(column & (cell - 1)) / cell, v = double(row & (cell - 1)) / cell;
    const auto at = [&](int i, int j) {
      return double(teMix(std::uint64_t(j) << 40 ^ std::uint64_t(i) << 8 ^ std::uint64_t(octave)) >> 11) *
             0x1p-53;
    };
    height += size * ((at(x, y) * (1 - u) + at(x + 1, y) * u) * (1 - v) +
                      (at(x, y + 1) * (1 - u) + at(x + 1, y + 1) * u) * v);
  }
  return float(std::floor(height));
}

TeLodFieldPtr makeField() {
  TeHeightMap map = TeHeightMap::create(kCells + 1, kCells + 1).value();
  std::vector<unsigned char> bytes(2 * std::size_t(kCells + 1) * std::size_t(kCells + 1));
  const char* name = std::getenv("TERRANE_BENCH_MAP");
  std::ifstream file(name ? name : "", std::ios::binary);
  const bool isRead = name && file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  for (int row = 0; row <= kCells; row++)
    for (int column = 0; column <= kCells; column++) {
      const std::size_t at = 2 * (std::size_t(row) * std::size_t(kCells + 1) + std::size_t(column));
      map.at(column, row) = isRead ? float(bytes[at] | bytes[at + 1] << 8) : noise(column, row);
    }
  TeLodField::Placement placement;
  placement.spacing = 10;
  placement.heightScale = 0.03;
  return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), placement).value();
}

const std::shared_ptr<const TeRoamBounds>& bounds() {
  static const std::shared_ptr<const TeRoamBounds> made = TeRoamBounds::create(makeField(), true);
  return made;
}

TeLodFieldPtr sharedField() { return {bounds(), &bounds()->field()}; }

TeFlyover flight(double anglePerFrame) {
  const TeLodField& field = bounds()->field();
  TeFlyover flight;
  flight.cells = field.cells();
  flight.spacing = field.spacing();
  flight.heightScale = field.heightScale();
  flight.sample = [&field](std::int32_t column, std::int32_t row) { return field.height(column, row); };
  flight.anglePerFrame = anglePerFrame;
  return flight;
}

/// `aim`, `document`: milliseconds a frame; 0: none.
void fly(benchmark::State& state, const TeRoamLod::Settings& settings, const TeLodAccuracy& accuracy,
         double angle, double aim, double document) {
  const TeFlyover flown = flight(angle);
  std::vector<TeLodView> views;
  for (int frame = 0; frame < kFrames; frame++)
    views.push_back(flown.view(frame).lodView());
  TeRoamLod lod(bounds(), sharedField(), settings);
  TeLodMesh mesh;
  lod.select(views[0], accuracy);
  lod.appendMesh(mesh);

  std::vector<double> chosen, written, whole;
  double triangles = 0, splits = 0, merges = 0, mostChanges = 0, bound = 0, least = 1e9, most = 0;
  std::size_t frame = 0;
  int step = 1; // there and back: no jump
  for (auto _ : state) {
    frame += std::size_t(step);
    step = frame + 1 == views.size() ? -1 : frame == 0 ? 1 : step;
    const double start = teThreadCpuSeconds();
    lod.select(views[frame], accuracy);
    const double selected = teThreadCpuSeconds();
    mesh.clear();
    lod.appendMesh(mesh);
    const double end = teThreadCpuSeconds();
    state.SetIterationTime(end - start);
    chosen.push_back(selected - start);
    written.push_back(end - selected);
    whole.push_back(end - start);
    const TeLodSelection& selection = lod.selection();
    triangles += double(selection.triangles);
    splits += double(selection.splits);
    merges += double(selection.merges);
    mostChanges = std::max(mostChanges, double(selection.splits + selection.merges));
    least = std::min(least, double(selection.triangles));
    most = std::max(most, double(selection.triangles));
    bound = std::max(bound, selection.errorBound);
  }
  const double frames = double(whole.size()), time = median(whole);
  state.counters["triangles"] = triangles / frames;
  state.counters["fewest"] = least;
  state.counters["most"] = most;
  state.counters["splits"] = splits / frames;
  state.counters["merges"] = merges / frames;
  state.counters["most_changes"] = mostChanges;
  state.counters["bound_px"] = bound;
  state.counters["select_us"] = 1e6 * median(chosen);
  state.counters["write_us"] = 1e6 * median(written);
  state.counters["ns_a_triangle"] = 1e9 * time * frames / triangles;
  state.counters["plain_ns_a_triangle"] = plainWriting(mesh);
  state.counters["ratio"] = state.counters["ns_a_triangle"] / state.counters["plain_ns_a_triangle"];
  if (aim > 0)
    state.counters["aims"] = 1e3 * time / aim;
  if (document > 0)
    state.counters["of_document"] = 1e3 * time / document;
}

void byCount(benchmark::State& state, TeRoamLod::Settings settings) {
  const auto count = double(state.range(0));
  TeLodAccuracy accuracy;
  accuracy.dial = count;
  fly(state, settings, accuracy, double(state.range(1)) / 1000,
      count == 3000    ? 0.15
      : count == 50000 ? 6
                       : 0,
      count == 3000   ? 32
      : count == 6000 ? 1000 / 12.0
                      : 0);
}

void roamByCount(benchmark::State& state) { byCount(state, {}); }

void roamByVariance(benchmark::State& state) {
  TeRoamLod::Settings settings;
  settings.metric = TeRoamMetric::Variance;
  byCount(state, settings);
}

/// The simplified form: each frame from the base.
void roamSplitOnly(benchmark::State& state) {
  TeRoamLod::Settings settings;
  settings.splitOnly = true;
  byCount(state, settings);
}

void roamByPixelError(benchmark::State& state) {
  TeLodAccuracy accuracy;
  accuracy.pixelError = double(state.range(0));
  fly(state, {}, accuracy, double(state.range(1)) / 1000, 0, 0);
}

void roamBuilding(benchmark::State& state) {
  const TeLodFieldPtr field = sharedField();
  const double samples = double(kCells + 1) * double(kCells + 1);
  double seconds = 0, bytes = 0;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    const auto made = TeRoamBounds::create(field, false);
    const double passed = teThreadCpuSeconds() - start;
    state.SetIterationTime(passed);
    seconds += passed;
    bytes = double(made->bytes());
  }
  state.counters["ns_a_sample"] = 1e9 * seconds / double(state.iterations()) / samples;
  state.counters["bytes_a_sample"] = bytes / samples;
}

} // namespace

// Wanted triangles or pixels, then thousandths of a degree a frame: 20 is a metre, 500 the flyover. "aims":
// times the milliseconds that a frame may take; "of_document": times those of document 000.
BENCHMARK(roamByCount)
    ->ArgsProduct({{3000, 6000, 30000, 50000, 100000}, {20, 500}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(roamByVariance)->ArgsProduct({{3000, 6000}, {20}})->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(roamSplitOnly)->ArgsProduct({{3000, 50000}, {20}})->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(roamByPixelError)
    ->ArgsProduct({{1, 4, 16}, {20, 500}})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(roamBuilding)->UseManualTime()->Unit(benchmark::kMillisecond);
