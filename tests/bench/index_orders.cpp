// Index orders: vertices transformed for a triangle (ACMR) with caches (first in, first out) of 8 to 32
// vertices, and the time of ordering. Meshes: 0 a grid of 64 × 64 cells, 1 a Seamless patch of three
// resolutions, 2 RTIN triangles of the terrain (rtinField.h) for 655 units, 3 triangle-quadtree ROAM of
// 50,000.

#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/order/TeIndexOrder.h"
#include "nodes/lod/order/TeTriangleStrips.h"
#include "nodes/lod/order/TeVertexFifo.h"
#include "tests/bench/rtinField.h"
#include "tests/nodes/lod/order/gridOf.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>

namespace {

/// What a method draws at an accuracy, seen from above the middle.
TeLodMesh drawnBy(const std::string& name, const TeLodAccuracy& accuracy, double height) {
  const std::unique_ptr<TeLodMethod> method = std::move(TeLodMethods::create(name, rtinField()).value());
  const double side = rtinField()->cells() * rtinField()->spacing();
  TeLodView view;
  view.eye = {0.5 * side, 0.5 * side, height};
  view.focal = 665.1;
  method->select(view, accuracy);
  TeLodMesh mesh;
  if (name == "seamless") { // the patch that has most triangles
    std::size_t most = 0;
    const std::vector<TeLodPart>& parts = method->selection().parts;
    for (std::size_t i = 1; i < parts.size(); i++)
      if (parts[i].triangles > parts[most].triangles)
        most = i;
    method->appendPart(most, mesh);
  } else {
    method->appendMesh(mesh);
  }
  return mesh;
}

const TeLodMesh& meshOf(int number) {
  static std::map<int, TeLodMesh> made;
  TeLodMesh& mesh = made[number];
  if (!mesh.indices.empty())
    return mesh;
  TeLodAccuracy accuracy;
  if (number == 0) {
    mesh = gridOf(64);
  } else if (number == 1) {
    accuracy.pixelError = 2;
    mesh = drawnBy("seamless", accuracy, 6000);
  } else if (number == 2) {
    accuracy.dial = 655 * rtinField()->heightScale();
    mesh = drawnBy("rtin", accuracy, 1e6);
  } else {
    accuracy.dial = 50000;
    mesh = drawnBy("roam", accuracy, 6000);
  }
  return mesh;
}

void order(benchmark::State& state) {
  const TeLodMesh& mesh = meshOf(int(state.range(0)));
  const TeIndexOrder::Kind kind = TeIndexOrder::all()[std::size_t(state.range(1))];
  state.SetLabel(TeIndexOrder::name(kind));
  double least = 1e9;
  std::vector<std::uint32_t> indices;
  for (auto _ : state) {
    const double start = teThreadCpuSeconds();
    TeResult<std::vector<std::uint32_t>> ordered = TeIndexOrder::apply(kind, mesh.vertices, mesh.indices);
    const double seconds = teThreadCpuSeconds() - start;
    if (!ordered) {
      state.SkipWithError(ordered.error().message.c_str());
      return;
    }
    indices = std::move(*ordered);
    state.SetIterationTime(seconds);
    least = std::min(least, seconds);
  }
  const double triangles = double(mesh.triangles());
  state.counters["triangles"] = triangles;
  state.counters["ns_a_triangle"] = 1e9 * least / triangles;
  state.counters["vertices_a_triangle"] = double(mesh.vertices.size()) / triangles;
  for (const int size : {8, 12, 16, 24, 32})
    state.counters["acmr_" + std::string(size < 10 ? "0" : "") + std::to_string(size)] =
        TeVertexFifo::missesPerTriangle(indices, mesh.vertices.size(), size);
  if (kind == TeIndexOrder::Kind::Strips)
    state.counters["sent_a_triangle"] =
        double(TeTriangleStrips::create(mesh.indices).encodeAll(mesh.indices).size()) / triangles;
}

} // namespace

BENCHMARK(order)
    ->Name("lod/index_order")
    ->ArgNames({"mesh", "order"})
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1, 2, 3, 4, 5}})
    ->UseManualTime()
    ->Iterations(5)
    ->Unit(benchmark::kMillisecond);
