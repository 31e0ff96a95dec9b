// What a piece of the surface costs to build, to draw for the first time and to draw again: Coin's own nodes
// (TePatchGraphBuilder) against SoTeTerrainMesh. CPU time of the drawing thread: llvmpipe fills in others, so
// that other programs disturb little. scene-bench [--context egl|osmesa] [Google Benchmark's options]

#include "bench/scene/benchContext.h"
#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeAllowance.h"
#include "nodes/TePatchGraphBuilder.h"
#include "nodes/TeSceneRenderer.h"
#include "nodes/terrain/TeMeshModelJob.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kSettlingFrames = 4; ///< in which Coin makes up its mind what to cache
constexpr int kFrames = 5;         ///< after them

/// The pieces of n × n patches of 33² heights, around (0, 0).
const std::vector<TePatchMeshPtr>& pieces(int n) {
  static std::map<int, std::vector<TePatchMeshPtr>> made;
  std::vector<TePatchMeshPtr>& all = made[n];
  if (!all.empty())
    return all;
  TeWorld world;
  world.lattice = *TeLattice::create(65, 1);
  world.sources = std::make_shared<TeSingleSource>(
      *TeGeneratorRegistry::instance().source("function:z=\"6*sin(x/7)*cos(y/9)\"", {}));
  const TeStaticBlock block = std::move(TeStaticBlock::build(world, {0, 0}, n).value());
  if (!block.forEachPiece(
          [&](const TePatchMesh& mesh) { all.push_back(std::make_shared<const TePatchMesh>(mesh)); }))
    std::abort();
  return all;
}

/// A scene of one kind of nodes, and the CPU milliseconds of its parts.
class Scene {
public:
  Scene(int n, bool ownNodes) : m_n(n), m_root(new SoSeparator) {
    m_camera = new SoPerspectiveCamera;
    m_root->addChild(m_camera);
    lookAtAll();
    auto* sun = new SoDirectionalLight;
    sun->direction.setValue(-0.3f, 1, -0.8f);
    m_root->addChild(sun);
    const std::vector<TePatchMeshPtr>& meshes = pieces(n);
    buildMs = timed([&] { ownNodes ? addMeshes(meshes) : addCoins(meshes); });
    m_renderer = std::move(TeSceneRenderer::create(*benchContext, kWidth, kHeight).value());
    m_renderer->setFitClipPlanes(false);
    firstMs = frame();
    for (int i = 1; i < kSettlingFrames; i++)
      settlingMs = std::max(settlingMs, frame());
    steadyMs = frame();
    for (int i = 1; i < kFrames; i++)
      steadyMs = std::min(steadyMs, frame());
  }

  double frame() {
    if (drawing)
      drawing->resetFrame(anchorBytes);
    return timed([&] {
      if (!m_renderer->draw(m_root.get()))
        std::abort();
    });
  }

  void lookAtAll() {
    const float side = float(m_n * 32);
    m_camera->position.setValue(0, -side, side);
    m_camera->pointAt(SbVec3f(0, 0, 0), SbVec3f(0, 0, 1));
    m_camera->nearDistance = 1;
    m_camera->farDistance = 4 * side;
  }
  void lookAway() { m_camera->pointAt(SbVec3f(0, -1e6f, 0), SbVec3f(0, 0, 1)); }

  double buildMs = 0;
  double firstMs = 0;
  double settlingMs = 0; ///< the dearest of the frames after the first
  double steadyMs = 0;
  std::shared_ptr<TeMeshDrawing> drawing; ///< of own nodes only
  std::size_t anchorBytes = 0;

private:
  template <class Work> static double timed(Work work) {
    const double start = teThreadCpuSeconds();
    work();
    return 1e3 * (teThreadCpuSeconds() - start);
  }

  void addCoins(const std::vector<TePatchMeshPtr>& meshes) {
    const TePatchGraphBuilder builder({0, 0});
    for (const TePatchMeshPtr& mesh : meshes)
      m_root->addChild(builder.build(*mesh).get());
  }

  void addMeshes(const std::vector<TePatchMeshPtr>& meshes) {
    drawing = std::make_shared<TeMeshDrawing>(glm::dvec2(0));
    auto* hints = new SoShapeHints;
    hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
    m_root->addChild(hints);
    m_root->addChild(drawing->translation());
    for (const TePatchMeshPtr& mesh : meshes) {
      TeMeshModelJob job(mesh, TeSurfaceColours(), drawing);
      TeAllowance allowance = TeAllowance::unlimited();
      job.step(allowance);
      m_root->addChild(job.take().get());
    }
  }

  int m_n;
  TeNodePtr<SoSeparator> m_root;
  SoPerspectiveCamera* m_camera;
  std::unique_ptr<TeSceneRenderer> m_renderer;
};

/// Least milliseconds of each part in all runs: what other programs add is left out.
struct Least {
  double build = 1e9;
  double first = 1e9;
  double settling = 1e9;
  double steady = 1e9;
  void add(const Scene& scene) {
    build = std::min(build, scene.buildMs);
    first = std::min(first, scene.firstMs);
    settling = std::min(settling, scene.settlingMs);
    steady = std::min(steady, scene.steadyMs);
  }
};

/// Both kinds of nodes; a ratio is how many times cheaper ours are. In the frames after the first Coin makes
/// display lists, from which it draws steadily; at every change around a piece it has to make them anew.
void scenes(benchmark::State& state) {
  const int n = int(state.range(0));
  Least coin;
  Least mesh;
  for (auto _ : state) {
    coin.add(Scene(n, false));
    mesh.add(Scene(n, true));
    state.SetIterationTime(mesh.first / 1e3);
  }
  state.counters["pieces"] = double(pieces(n).size());
  state.counters["build_ms_coin"] = coin.build;
  state.counters["build_ms_mesh"] = mesh.build;
  state.counters["build_ratio"] = coin.build / mesh.build;
  state.counters["first_ms_coin"] = coin.first;
  state.counters["first_ms_mesh"] = mesh.first;
  state.counters["first_ratio"] = coin.first / mesh.first;
  state.counters["settling_ms_coin"] = coin.settling;
  state.counters["settling_ms_mesh"] = mesh.settling;
  state.counters["settling_ratio"] = coin.settling / mesh.settling;
  state.counters["steady_ms_coin"] = coin.steady;
  state.counters["steady_ms_mesh"] = mesh.steady;
  state.counters["steady_ratio"] = coin.steady / mesh.steady;
  state.counters["build_us_a_patch"] = 1e3 * mesh.build / (n * n);
}

/// All meshes out of view.
void culledFrame(benchmark::State& state) {
  Scene scene(int(state.range(0)), true);
  scene.lookAway();
  scene.frame();
  for (auto _ : state)
    state.SetIterationTime(scene.frame() / 1e3);
  state.counters["meshes_drawn"] = double(scene.drawing->frame().meshesDrawn);
  state.counters["pieces"] = double(pieces(int(state.range(0))).size());
}

/// The frames of changes of anchor, 256 KiB in each: the median of those with uploads, and the least of those
/// that are the first after a commitment, against a steady one.
void anchorChange(benchmark::State& state) {
  Scene scene(int(state.range(0)), true);
  scene.anchorBytes = 1 << 18;
  std::vector<double> uploads;
  double committed = 1e9;
  for (auto _ : state) {
    scene.drawing->beginAnchor(scene.drawing->anchor() + glm::dvec2(32, 0));
    while (!scene.drawing->nextAnchorReady())
      uploads.push_back(scene.frame());
    scene.drawing->commitAnchor();
    const double after = scene.frame();
    committed = std::min(committed, after);
    state.SetIterationTime(after / 1e3);
  }
  std::nth_element(uploads.begin(), uploads.begin() + std::ptrdiff_t(uploads.size() / 2), uploads.end());
  state.counters["pieces"] = double(pieces(int(state.range(0))).size());
  state.counters["steady_ms"] = scene.steadyMs;
  state.counters["upload_frame_ms"] = uploads[uploads.size() / 2];
  state.counters["committed_frame_ms"] = committed;
  state.counters["frames"] = double(uploads.size()) / double(state.iterations());
  state.counters["ns_a_byte"] = 1e9 * scene.drawing->secondsPerByte();
}

// 9 and 1089 patches, with seams and corners.
BENCHMARK(scenes)->Arg(3)->UseManualTime()->Iterations(8)->Unit(benchmark::kMillisecond);
BENCHMARK(scenes)->Arg(33)->UseManualTime()->Iterations(2)->Unit(benchmark::kMillisecond);
BENCHMARK(culledFrame)->Arg(33)->UseManualTime()->Iterations(20)->Unit(benchmark::kMillisecond);
BENCHMARK(anchorChange)->Arg(9)->UseManualTime()->Iterations(8)->Unit(benchmark::kMillisecond);

} // namespace
