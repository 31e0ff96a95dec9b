#include "generators/base/TeRandom.h"
#include "patchdb/TeFourMapBlend.h"
#include "patchdb/TePatchDatabase.h"
#include "patchdb/TeSurfaceNormals.h"
#include "tests/bench/TeBenchmarkReport.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

TeHeightMap randomMap(int side, std::uint64_t seed) {
  TeHeightMap map = TeHeightMap::create(side, side).value();
  TeRandom random(seed, 2, {3, 4});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map.at(x, y) = float(random.uniform(-100.0, 100.0));
  return map;
}

/// A square block of patches and their source maps, visited in shuffled order: with enough of them nothing
/// is in the caches when its turn comes.
class BlendField {
public:
  BlendField(int samples, int patches) : m_patches(patches), m_cells((samples - 1) / 2) {
    const TeHeightMap map = randomMap(samples, 1);
    m_maps.assign(std::size_t(patches + 1) * std::size_t(patches + 1), map);
    m_heights.assign(std::size_t(patches) * std::size_t(patches),
                     TeHeightMap::create(m_cells + 1, m_cells + 1).value());
    m_order.resize(m_heights.size());
    std::iota(m_order.begin(), m_order.end(), 0);
    TeRandom random(9, 9, {});
    for (std::size_t i = m_order.size(); i > 1; --i)
      std::swap(m_order[i - 1], m_order[random.below(i)]);
  }

  void next() {
    m_at = (m_at + 1) % m_order.size();
    m_x = m_order[m_at] % m_patches;
    m_y = m_order[m_at] / m_patches;
  }
  const TeHeightMap& map(int corner) const {
    return m_maps[std::size_t(m_y + corner / 2) * std::size_t(m_patches + 1) + std::size_t(m_x + corner % 2)];
  }
  TeHeightMap& heights() { return m_heights[std::size_t(m_y) * std::size_t(m_patches) + std::size_t(m_x)]; }
  int cells() const { return m_cells; }

  /// Four quarters of maps read, one patch written: a copy of half as many bytes moves as much.
  TeBenchmarkWork work() const {
    const std::size_t patch = std::size_t(m_cells + 1) * std::size_t(m_cells + 1) * sizeof(float);
    TeBenchmarkWork work{std::int64_t(patch / sizeof(float)), 5 * patch / 2, 0};
    work.workingSet = m_order.size() > 1 ? work.copyBytes * m_order.size() : 0;
    return work;
  }

private:
  int m_patches;
  int m_cells;
  std::vector<TeHeightMap> m_maps;
  std::vector<TeHeightMap> m_heights;
  std::vector<int> m_order;
  std::size_t m_at = 0;
  int m_x = 0;
  int m_y = 0;
};

void blend(benchmark::State& state) {
  BlendField field(int(state.range(0)), int(state.range(1)));
  TeBenchmarkWork work = field.work();
  work.targetCopies = 1.3;
  const TeBlendWeights weights((int(state.range(0)) - 1) / 2, TeBlendProfile::Smooth);
  teBenchmark(state, work, [&] {
    field.next();
    TeFourMapBlend(weights, field.map(0), field.map(1), field.map(2), field.map(3), field.heights()).finish();
    benchmark::ClobberMemory();
  });
}

/// The least that blending can do: the same rows of the same maps read, the same patch written.
void moveQuarters(benchmark::State& state) {
  BlendField field(int(state.range(0)), int(state.range(1)));
  const int n = field.cells();
  teBenchmark(state, field.work(), [&] {
    field.next();
    for (int y = 0; y <= n; ++y) {
      const auto bits = [](const float* row) { return reinterpret_cast<const std::uint32_t*>(row); };
      const std::uint32_t* a = bits(field.map(0).row(n + y) + n);
      const std::uint32_t* b = bits(field.map(1).row(n + y));
      const std::uint32_t* c = bits(field.map(2).row(y) + n);
      const std::uint32_t* d = bits(field.map(3).row(y));
      std::uint32_t* out = reinterpret_cast<std::uint32_t*>(field.heights().row(y));
      for (int x = 0; x <= n; ++x)
        out[x] = a[x] ^ b[x] ^ c[x] ^ d[x];
    }
    benchmark::ClobberMemory();
  });
}

void normals(benchmark::State& state) {
  const int side = (int(state.range(0)) + 1) / 2;
  const TeHeightMap heights = randomMap(side, 1);
  std::vector<glm::vec3> out(std::size_t(side - 2) * std::size_t(side - 2));
  TeBenchmarkWork work{std::int64_t(out.size()), (heights.bytes() + out.size() * sizeof(glm::vec3)) / 2};
  teBenchmark(state, work, [&] {
    teGridNormals(heights.row(1) + 1, side, side - 2, side - 2, 1.0, false, out.data());
    benchmark::ClobberMemory();
  });
}

class Hills final : public TePointSource {
public:
  std::string name() const override { return "hills"; }
  std::uint64_t fingerprint() const override { return 1; }
  bool fits() const override { return true; }
  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    for (std::size_t i = 0; i < count; ++i)
      heights[i] =
          float(20 * std::sin(request.x(samples[i].column) / 40) * std::cos(request.y(samples[i].row) / 55));
    return {};
  }
};

/// A square block of patches around the origin; its half side in metres.
std::unique_ptr<TePatchDatabase> hills(int samples, int patches, double& reach) {
  const TeWorld world{TeLattice::create(samples, 1.0).value(), 0,
                      std::make_shared<TeSingleSource>(std::make_shared<Hills>())};
  auto database = std::move(TePatchDatabase::create(world).value());
  for (int y = 0; y < patches; ++y)
    for (int x = 0; x < patches; ++x)
      database->build({x - patches / 2, y - patches / 2, 0}).value()->dropMaps();
  reach = (patches / 2 - 0.51) * world.lattice.patchSide();
  return database;
}

void patchModel(benchmark::State& state) {
  double reach;
  const auto database = hills(int(state.range(0)), 2, reach);
  const TePatchData& patch = *database->find({0, 0, 0});
  const TePatchMesh mesh = database->patchMesh(patch).value();
  TeBenchmarkWork work{std::int64_t(mesh.positions.size()), (patch.heights().bytes() + mesh.bytes()) / 2};
  teBenchmark(state, work,
              [&] { benchmark::DoNotOptimize(database->patchMesh(patch).value().positions.data()); });
}

void seamModel(benchmark::State& state) {
  double reach;
  const auto database = hills(int(state.range(0)), 2, reach);
  const TePatchData& patch = *database->find({-1, -1, 0});
  const TePatchMesh mesh = database->seamMesh(patch, TeDirection::East).value();
  TeBenchmarkWork work{std::int64_t(mesh.positions.size()), mesh.bytes()};
  teBenchmark(state, work, [&] {
    benchmark::DoNotOptimize(database->seamMesh(patch, TeDirection::East).value().positions.data());
  });
}

/// Points scattered over a block of patches, or near each other as those of a walker.
void heightAt(benchmark::State& state, bool scattered) {
  double reach;
  const auto database = hills(65, int(state.range(0)), reach);
  TeRandom random(4, 4, {});
  std::vector<glm::dvec2> points(4096);
  glm::dvec2 walker(0, 0);
  for (glm::dvec2& point : points) {
    walker += glm::dvec2(random.uniform(-0.2, 0.25), random.uniform(-0.2, 0.2));
    point = scattered ? glm::dvec2(random.uniform(-reach, reach), random.uniform(-reach, reach)) : walker;
  }
  std::size_t i = 0;
  double sum = 0;
  for (auto _ : state) {
    sum += *database->heightAt(points[i]);
    i = (i + 1) % points.size();
  }
  benchmark::DoNotOptimize(sum);
  state.counters["queries/s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["target_ns"] = 40;
}

void heightScattered(benchmark::State& state) { heightAt(state, true); }
void heightWalking(benchmark::State& state) { heightAt(state, false); }

/// Slanted rays from 60 m up over a block of patches, somewhere within it.
void slantedRays(benchmark::State& state) {
  double reach;
  const auto database = hills(65, int(state.range(0)), reach);
  TeRandom random(6, 4, {});
  std::vector<glm::dvec3> origins(4096), directions(4096);
  for (std::size_t i = 0; i < origins.size(); ++i) {
    origins[i] = {random.uniform(-reach, reach) / 2, random.uniform(-reach, reach) / 2, 60};
    const double angle = random.uniform(0, 6.283);
    directions[i] = {std::cos(angle), std::sin(angle), random.uniform(-1.0, -0.25)};
  }
  std::size_t i = 0;
  std::int64_t hits = 0;
  for (auto _ : state) {
    hits += database->intersect(origins[i], directions[i], INFINITY) ? 1 : 0;
    i = (i + 1) % origins.size();
  }
  state.counters["rays/s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["hits"] = double(hits) / double(std::max<std::int64_t>(1, state.iterations()));
}

} // namespace

// Maps of 65² in the cache and from memory; larger patches.
BENCHMARK(blend)->Args({65, 1})->Args({65, 64})->Args({257, 1})->Args({257, 20});
BENCHMARK(moveQuarters)->Args({65, 1})->Args({65, 64})->Args({257, 1})->Args({257, 20});
BENCHMARK(normals)->Arg(65)->Arg(257);
BENCHMARK(patchModel)->Arg(65)->Arg(257);
BENCHMARK(seamModel)->Arg(65);
BENCHMARK(heightScattered)->Arg(2)->Arg(8)->Arg(64);
BENCHMARK(heightWalking)->Arg(8);
BENCHMARK(slantedRays)->Arg(16);
