#include "apps/terrane-accuracy/TeLodSweep.h"

#include "apps/terrane-accuracy/TeMeshCheck.h"
#include "apps/terrane-accuracy/TeRawMesh.h"
#include "generators/base/TeAllowance.h"

#include <algorithm>

namespace {

constexpr int kRuns = 3;

double selectMs(TeMeasuredMethod& method, const TeLodView& view, const TeDial& dial) {
  double least = 1e9;
  for (int run = 0; run < kRuns; run++) {
    const double start = teThreadCpuSeconds();
    method.select(view, dial);
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return 1e3 * least;
}

void draw(const TeMeasuredMethod& method, std::vector<TeSeamlessMesh::Triangle>& mesh,
          TeDrawnSurface& surface) {
  mesh.clear();
  method.appendMesh(mesh);
  surface.draw(mesh);
}

TeScreenError::Report measure(const std::vector<TeSeamlessMesh::Triangle>& mesh, const TeLodView& view,
                              TeScreenError& error) {
  const auto vertex = [](const TeSeamlessMesh::Vertex& v) {
    return TeScreenError::Vertex{v.column, v.row, v.height};
  };
  error.clear();
  for (const TeSeamlessMesh::Triangle& triangle : mesh)
    error.add(vertex(triangle.a), vertex(triangle.b), vertex(triangle.c));
  return error.measure(view);
}

} // namespace

TeLodFigures teMeasureLod(TeMeasuredMethod& method, const TeDial& dial, const TeMeasuredTerrain& terrain,
                          const TeFlyover& flight, int frames, int stride,
                          const std::function<void(int)>& progress) {
  // Of the bound, for what rounds in heights as float and in positions.
  constexpr double kRounding = 1 + 1e-5;
  TeLodFigures figures;
  std::vector<double> times;
  std::vector<TeSeamlessMesh::Triangle> mesh;
  TeDrawnSurface surface(terrain.cells());
  TeDrawnSurface next(terrain.cells());
  TeScreenError error(terrain.heights, glm::dvec3(0), terrain.spacing, terrain.heightScale);
  for (int i = 0; i < frames; i++) {
    const TeLodView view = flight.view(i * stride).lodView();
    times.push_back(selectMs(method, view, dial));
    const TeSelected selected = method.selected();
    figures.triangles += double(selected.triangles) / frames;
    figures.drawCalls += double(selected.drawCalls) / frames;
    figures.parts += double(selected.parts) / frames;
    figures.visited += double(selected.visited) / frames;
    figures.uploadBytes += double(selected.uploadBytes) / frames;
    figures.dial += selected.dial / frames;
    figures.boundPixels = std::max(figures.boundPixels, selected.boundPixels);

    // With a stride of 1 the surface is the one that followed the last frame.
    if (i == 0 || stride > 1 || mesh.empty())
      draw(method, mesh, surface);
    else
      std::swap(surface, next);
    figures.cracks += teCountCracks(mesh, terrain, view);
    const TeScreenError::Report report = measure(mesh, view, error);
    figures.errors.add(report);
    figures.overshoots += report.worst > selected.boundPixels * kRounding + 1e-9;

    const TeLodView following = flight.view(i * stride + 1).lodView();
    method.select(following, dial);
    draw(method, mesh, next);
    figures.errors.addJump(terrain, following, surface, next);
    progress(i + 1);
  }
  figures.selectMs = TeSpread::of(std::move(times));
  return figures;
}

TeResult<TeFrameFigures> teMeasureFrames(TeMeasuredMethod& method, const TeDial& dial,
                                         const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                                         int frames, int stride, TeFlightStage& stage) {
  TeResult<std::unique_ptr<TeRawMesh>> raw = TeRawMesh::create(stage.context());
  if (!raw)
    return raw.error();
  std::vector<double> times, rawTimes, ratios;
  std::vector<TeSeamlessMesh::Triangle> mesh;
  // Frame -1 is drawn for what happens but once: shaders, heights. Raw, each frame twice, as its data are
  // new.
  for (int i = -1; i < frames; i++) {
    const TePerspectiveView view = flight.view(i * stride);
    stage.show(method.node(dial));
    const TeResult<double> ms = stage.draw(view);
    if (!ms)
      return ms.error();
    mesh.clear();
    method.select(view.lodView(), dial);
    method.appendMesh(mesh);
    (*raw)->load(mesh, terrain);
    stage.show((*raw)->node());
    const TeResult<double> first = stage.draw(view);
    const TeResult<double> rawMs = stage.draw(view);
    if (!first || !rawMs)
      return first ? rawMs.error() : first.error();
    if (i < 0)
      continue;
    times.push_back(*ms);
    rawTimes.push_back(*rawMs);
    ratios.push_back(*ms / std::max(1e-9, *rawMs));
  }
  return TeFrameFigures{TeSpread::of(std::move(times)), TeSpread::of(std::move(rawTimes)),
                        TeSpread::of(std::move(ratios))};
}
