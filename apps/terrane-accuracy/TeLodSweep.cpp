#include "apps/terrane-accuracy/TeLodSweep.h"

#include "apps/terrane-accuracy/TeLodDrawing.h"
#include "apps/terrane-accuracy/TeRawMesh.h"
#include "generators/base/TeAllowance.h"
#include "nodes/lod/TeMeshGaps.h"

#include <algorithm>

namespace {

constexpr int kRuns = 3;
/// Of the bound, for what rounds in heights as float and in positions.
constexpr double kRounding = 1 + 1e-5;

double selectMs(TeLodCandidate& candidate, const TeLodView& before, const TeLodView& view,
                const TeLodAccuracy& accuracy) {
  double least = 1e9;
  for (int run = 0; run < kRuns; run++) {
    candidate.select(before, accuracy);
    const double start = teThreadCpuSeconds();
    candidate.select(view, accuracy);
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return 1e3 * least;
}

TeScreenError::Report errorsOf(const TeLodMesh& mesh, const TeLodView& view, TeScreenError& error) {
  error.clear();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  return error.measure(view);
}

std::unordered_set<std::uint64_t> keysOf(const TeLodSelection& selection) {
  std::unordered_set<std::uint64_t> keys;
  for (const TeLodPart& part : selection.parts)
    keys.insert(part.key);
  return keys;
}

} // namespace

TeLodFigures teMeasureLod(TeLodCandidate& candidate, const TeLodAccuracy& accuracy,
                          const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                          const TeMeasuredFrames& frames, const std::function<void(int)>& progress) {
  TeLodFigures figures;
  std::vector<double> times;
  TeLodMesh mesh, nextMesh;
  TeDrawnSurface surface(terrain.cells());
  TeDrawnSurface next(terrain.cells());
  TeScreenError error(terrain.heights(), glm::dvec3(0), terrain.spacing(), terrain.heightScale());
  TeMeshGaps gaps(terrain.field);
  const double share = 1.0 / frames.count;
  for (int i = 0; i < frames.count; i++) {
    const TeLodView before = flight.view(i * frames.stride - 1).lodView();
    const TeLodView view = flight.view(i * frames.stride).lodView();
    candidate.select(before, accuracy);
    const std::unordered_set<std::uint64_t> known = keysOf(candidate.selection());
    times.push_back(selectMs(candidate, before, view, accuracy));
    const TeLodSelection& selected = candidate.selection();
    const double bound = selected.errorBound;
    figures.triangles += double(selected.triangles) * share;
    figures.drawCalls += double(candidate.drawCalls()) * share;
    figures.parts += double(selected.parts.size()) * share;
    figures.visited += double(selected.visited) * share;
    figures.changes += double(selected.splits + selected.merges) * share;
    figures.uploadBytes += double(candidate.uploadBytes(known)) * share;
    figures.dial += selected.dial * share;
    figures.boundPixels = std::max(figures.boundPixels, bound);

    mesh.clear();
    candidate.method().appendMesh(mesh);
    figures.cracks += gaps.count(mesh, view);
    const TeScreenError::Report report = errorsOf(mesh, view, error);
    figures.errors.add(report);
    figures.overshoots += report.worst > bound * kRounding + 1e-9;

    const TeLodView following = flight.view(i * frames.stride + 1).lodView();
    candidate.select(following, accuracy);
    nextMesh.clear();
    candidate.method().appendMesh(nextMesh);
    surface.draw(mesh);
    next.draw(nextMesh);
    figures.errors.addJump(*terrain.field, following, surface, next);
    progress(i + 1);
  }
  figures.selectMs = TeSpread::of(std::move(times));
  return figures;
}

TeResult<TeFrameFigures> teMeasureFrames(TeLodCandidate& candidate, const TeLodAccuracy& accuracy,
                                         const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                                         const TeMeasuredFrames& frames, TeFlightStage& stage) {
  TeResult<std::unique_ptr<TeRawMesh>> raw = TeRawMesh::create(stage.context());
  if (!raw)
    return raw.error();
  TeResult<std::unique_ptr<TeLodDrawing>> drawing = TeLodDrawing::create(candidate, terrain, stage);
  if (!drawing)
    return drawing.error();
  std::vector<double> times, rawTimes, ratios;
  TeLodMesh mesh;
  for (int i = 0; i < frames.count; i++) {
    // Raw, each frame twice, as its data are new.
    const TePerspectiveView view = flight.view(i * frames.stride);
    const TeResult<double> before = (*drawing)->draw(accuracy, flight.view(i * frames.stride - 1));
    const TeResult<double> ms = before ? (*drawing)->draw(accuracy, view) : before;
    if (!ms)
      return ms.error();
    mesh.clear();
    candidate.select(view.lodView(), accuracy);
    candidate.method().appendMesh(mesh);
    (*raw)->load(mesh, *terrain.field);
    stage.show((*raw)->node());
    const TeResult<double> first = stage.draw(view);
    const TeResult<double> rawMs = stage.draw(view);
    if (!first || !rawMs)
      return first ? rawMs.error() : first.error();
    times.push_back(*ms);
    rawTimes.push_back(*rawMs);
    ratios.push_back(*ms / std::max(1e-9, *rawMs));
  }
  return TeFrameFigures{TeSpread::of(std::move(times)), TeSpread::of(std::move(rawTimes)),
                        TeSpread::of(std::move(ratios))};
}
