// Point heights and slanted rays on a patch database, beside Bullet's height field over the same samples in
// the same run: counters bullet_ns and times_bullet (how many times as fast). `differ_m`: the largest
// difference of the answers.

#include "generators/base/TeRandom.h"
#include "generators/midpoint/TeMidpointDisplacement.h"
#include "patchdb/TePatchDatabase.h"
#include "tests/bench/TeBenchmarkReport.h"
#ifdef TERRANE_HAVE_BULLET
#include "tests/bench/TeBulletField.h"
#endif

#include <cmath>
#include <cstdlib>

namespace {

constexpr int kCells = 32; ///< a side of a patch
constexpr double kSpacing = 10;
constexpr std::size_t kQueries = 4096;

enum class Land { Hills, Mountains };

TeHeightMap heightsOf(Land land, int side) {
  TeHeightMap map = TeHeightMap::create(side, side).value();
  if (land == Land::Hills) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        map.at(x, y) = float(200 * std::sin(x / 40.0) * std::cos(y / 55.0));
    return map;
  }
  TeMidpointParameters parameters;
  parameters.displacement = 600;
  parameters.fall = 0.55;
  const auto source = TeMidpointDisplacement::create(parameters).value();
  return source->generate(TeMapRequest::standalone(side, side, kSpacing, 1).value()).value();
}

/// Land in a database of patches, centred on the origin.
struct World {
  World(Land land, int patches) : heights(heightsOf(land, patches * kCells + 1)) {
    const TeLattice lattice = TeLattice::create(2 * kCells + 1, kSpacing).value();
    // Only heights that are set are asked for.
    const auto sources = std::make_shared<TeSingleSource>(TeMidpointDisplacement::create({}).value());
    database = std::move(TePatchDatabase::create({lattice, 0, sources}).value());
    for (int y = 0; y < patches; ++y)
      for (int x = 0; x < patches; ++x) {
        TeHeightMap part = TeHeightMap::create(kCells + 1, kCells + 1).value();
        if (!part.copy(heights, {x * kCells, y * kCells, kCells + 1, kCells + 1}, part.bounds()))
          std::abort();
        database->lookup({x, y, 0}, TeLookup::Create).value()->setHeights(std::move(part));
      }
    origin = lattice.position(0);
    side = (heights.width() - 1) * kSpacing;
  }

  /// Of a point 0 .. side from the south-west corner.
  double at(double offset) const { return origin + offset; }
  /// The same for the peer, whose middle is its origin.
  double peer(double offset) const { return offset - 0.5 * side; }
  double bytesPerSample() const {
    std::size_t bytes = database->tree().bytes();
    database->tree().level(0).traverse([](const TeGrowingTree::Bounds&) { return 0.0; },
                                       [&](const TePatchData& patch) {
                                         bytes += patch.bytes();
                                         return true;
                                       });
    return double(bytes) / double(heights.bytes() / sizeof(float));
  }

  TeHeightMap heights;
  std::unique_ptr<TePatchDatabase> database;
  double origin = 0;
  double side = 0;
};

/// Seconds of one of `count` calls: the median of five runs over all of them.
template <class Call> [[maybe_unused]] double secondsOf(std::size_t count, Call call) {
  std::vector<double> seconds;
  for (int run = 0; run < 5; ++run) {
    const double start = teThreadCpuSeconds();
    for (std::size_t i = 0; i < count; ++i)
      call(i);
    seconds.push_back((teThreadCpuSeconds() - start) / double(count));
  }
  std::nth_element(seconds.begin(), seconds.begin() + 2, seconds.end());
  return seconds[2];
}

/// Runs call(0 .. kQueries-1) over and over; returns seconds a call.
template <class Call> double loop(benchmark::State& state, Call call) {
  std::size_t i = 0;
  const double start = teThreadCpuSeconds();
  for (auto _ : state) {
    call(i);
    i = (i + 1) % kQueries;
  }
  return (teThreadCpuSeconds() - start) / double(std::max<std::int64_t>(1, state.iterations()));
}

void pointHeights(benchmark::State& state, Land land, bool scattered) {
  const World world(land, int(state.range(0)));
  TeRandom random(4, 4, {});
  std::vector<glm::dvec2> points(kQueries);
  glm::dvec2 walker(world.side / 2, world.side / 2);
  for (glm::dvec2& point : points) {
    walker += glm::dvec2(random.uniform(-2, 2.5), random.uniform(-2, 2));
    point = scattered ? glm::dvec2(random.uniform(0, world.side), random.uniform(0, world.side)) : walker;
  }
  double sum = 0;
  const double ours = loop(state, [&](std::size_t i) {
    sum += *world.database->heightAt({world.at(points[i].x), world.at(points[i].y)});
  });
  benchmark::DoNotOptimize(sum);
  state.counters["ns"] = 1e9 * ours;
  state.counters["target_ns"] = 40;
#ifdef TERRANE_HAVE_BULLET
  const TeBulletField bullet(world.heights, kSpacing);
  double differ = 0;
  for (const glm::dvec2& point : points)
    differ =
        std::max(differ, std::fabs(bullet.heightAt(world.peer(point.x), world.peer(point.y)).value_or(NAN) -
                                   *world.database->heightAt({world.at(point.x), world.at(point.y)})));
  const double peer = secondsOf(kQueries, [&](std::size_t i) {
    sum += bullet.heightAt(world.peer(points[i].x), world.peer(points[i].y)).value_or(0);
  });
  benchmark::DoNotOptimize(sum);
  state.counters["bullet_ns"] = 1e9 * peer;
  state.counters["times_bullet"] = peer / ours;
  state.counters["differ_m"] = differ;
#endif
}

/// The same points all at once.
void manyHeights(benchmark::State& state, Land land) {
  const World world(land, int(state.range(0)));
  TeRandom random(4, 4, {});
  std::vector<glm::dvec2> points(kQueries);
  for (glm::dvec2& point : points)
    point = {world.at(random.uniform(0, world.side)), world.at(random.uniform(0, world.side))};
  std::vector<double> heights(kQueries);
  const double start = teThreadCpuSeconds();
  for (auto _ : state)
    world.database->heightsAt(points.data(), kQueries, heights.data());
  const double seconds = teThreadCpuSeconds() - start;
  benchmark::DoNotOptimize(heights.data());
  state.counters["ns"] =
      1e9 * seconds / double(kQueries) / double(std::max<std::int64_t>(1, state.iterations()));
  state.counters["target_ns"] = 40;
}

/// From 150 m above the ground anywhere in the middle half, in all directions, between 14 and 45 degrees
/// down.
void slantedRays(benchmark::State& state, Land land) {
  const World world(land, int(state.range(0)));
  TeRandom random(6, 4, {});
  std::vector<glm::dvec3> origins(kQueries), directions(kQueries);
  for (std::size_t i = 0; i < kQueries; ++i) {
    const double x = random.uniform(0.25, 0.75) * world.side, y = random.uniform(0.25, 0.75) * world.side;
    origins[i] = {x, y, *world.database->heightAt({world.at(x), world.at(y)}) + 150};
    const double angle = random.uniform(0, 6.283);
    directions[i] = {std::cos(angle), std::sin(angle), random.uniform(-1.0, -0.25)};
  }
  const double length = 0.25 * world.side; // stays over the land
  const auto ours = [&](std::size_t i) {
    const glm::dvec3 from(world.at(origins[i].x), world.at(origins[i].y), origins[i].z);
    return world.database->intersect(from, directions[i], length);
  };
  std::int64_t hits = 0;
  const double seconds = loop(state, [&](std::size_t i) { hits += ours(i) ? 1 : 0; });
  state.counters["Mrays/s"] = 1e-6 / seconds;
  state.counters["target_Mrays/s"] = 1;
  state.counters["bytes/sample"] = world.bytesPerSample();
  state.counters["hits"] = double(hits) / double(std::max<std::int64_t>(1, state.iterations()));
#ifdef TERRANE_HAVE_BULLET
  const TeBulletField bullet(world.heights, kSpacing);
  const auto theirs = [&](std::size_t i) {
    const glm::dvec3 from(world.peer(origins[i].x), world.peer(origins[i].y), origins[i].z);
    return bullet.cast(from, from + length * directions[i]);
  };
  double differ = 0;
  std::int64_t disagree = 0;
  for (std::size_t i = 0; i < kQueries; ++i) {
    const std::optional<TeRayHit> a = ours(i);
    const std::optional<double> b = theirs(i);
    disagree += a.has_value() != b.has_value() ? 1 : 0;
    if (a && b)
      differ = std::max(differ, std::fabs(a->distance - *b * length));
  }
  const double peer = secondsOf(kQueries / 4, [&](std::size_t i) { hits += theirs(i) ? 1 : 0; });
  state.counters["bullet_Mrays/s"] = 1e-6 / peer;
  state.counters["times_bullet"] = peer / seconds;
  state.counters["bullet_bytes/sample"] =
      double(bullet.bytes()) / double(world.heights.bytes() / sizeof(float));
  state.counters["differ_m"] = differ;
  state.counters["disagree"] = double(disagree);
#endif
}

} // namespace

BENCHMARK_CAPTURE(pointHeights, hills_walking, Land::Hills, false)->Arg(8);
BENCHMARK_CAPTURE(pointHeights, mountains_walking, Land::Mountains, false)->Arg(64);
BENCHMARK_CAPTURE(pointHeights, mountains_scattered, Land::Mountains, true)->Arg(8)->Arg(64);
BENCHMARK_CAPTURE(manyHeights, mountains_scattered, Land::Mountains)->Arg(8)->Arg(64);
BENCHMARK_CAPTURE(slantedRays, hills, Land::Hills)->Arg(16)->Arg(64);
BENCHMARK_CAPTURE(slantedRays, mountains, Land::Mountains)->Arg(16)->Arg(64);
