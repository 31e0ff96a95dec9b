#include "apps/terrane-accuracy/TeInstancingSweep.h"

#include "apps/terrane-accuracy/TePlainTraversal.h"
#include "generators/base/TeAllowance.h"
#include "nodes/seamless/TeSeamlessLists.h"
#include "nodes/seamless/TeSeamlessSelector.h"

#include <algorithm>

namespace {

constexpr int kRuns = 3;

/// CPU milliseconds, the least of some runs.
template <class Work> double leastMs(Work work) {
  double least = 1e9;
  for (int run = 0; run < kRuns; run++) {
    const double start = teThreadCpuSeconds();
    work();
    least = std::min(least, teThreadCpuSeconds() - start);
  }
  return 1e3 * least;
}

/// One node on the stage, and what its frames come to.
class Drawn {
public:
  Drawn(TeNodePtr<SoTeSeamlessPatches> node, TeInstancingWay way, double precision, int frames)
      : m_node(std::move(node)), m_frames(frames) {
    m_node->instancing = way != TeInstancingWay::Classic;
    m_node->wholePatches = way == TeInstancingWay::Whole;
    m_node->precision = float(precision);
  }

  /// Draws a frame without counting it; tells whether clipmaps were loaded for it.
  TeResult<bool> prepare(TeFlightStage& stage, const TePerspectiveView& view) {
    stage.show(m_node.get());
    const TeResult<double> ms = stage.draw(view);
    if (!ms)
      return ms.error();
    if (!m_node->getError().empty())
      return TeError{m_node->getError()};
    return m_node->statistics().bytesUploaded > kLoading;
  }

  TeStatus draw(TeFlightStage& stage, const TePerspectiveView& view) {
    stage.show(m_node.get());
    const TeResult<double> ms = stage.draw(view);
    if (!ms)
      return ms.error();
    const TeSeamlessStatistics& statistics = m_node->statistics();
    m_figures.drawCalls += double(statistics.drawCalls) / m_frames;
    m_figures.triangles += double(statistics.faces) / m_frames;
    m_figures.uploadBytes += double(statistics.bytesUploaded) / m_frames;
    m_selectMs.push_back(1e3 * statistics.selectionSeconds);
    m_frameMs.push_back(*ms);
    return {};
  }

  TeDrawingFigures figures() {
    m_figures.selectMs = TeSpread::of(m_selectMs);
    m_figures.frameMs = TeSpread::of(m_frameMs);
    return m_figures;
  }

private:
  static constexpr std::int64_t kLoading = 1 << 18; ///< more than a frame's instances take

  TeNodePtr<SoTeSeamlessPatches> m_node;
  int m_frames;
  TeDrawingFigures m_figures;
  std::vector<double> m_selectMs;
  std::vector<double> m_frameMs;
};

} // namespace

TeResult<TeSelectionFigures> TeInstancingSweep::select(double precision, const Progress& progress) const {
  const TeSeamlessLayout& layout = m_bounds->layout();
  const TeResult<std::unique_ptr<TeClipWindows>> windows = m_terrain.windows(layout);
  if (!windows)
    return windows.error();
  const double scale = double(m_terrain.cells()) / layout.resolution();
  TeSeamlessPlacement placement;
  placement.spacing = m_terrain.spacing() * scale;
  placement.heightScale = m_terrain.heightScale();
  placement.range = m_bounds->range(0, 0, 0);
  TeSeamlessAccuracy accuracy;
  accuracy.precision = precision;
  const TeSeamlessSelector selector(layout, m_bounds);
  const TeSeamlessParts parts(layout);
  const TeSeamlessParts whole(layout, true);
  TePlainTraversal plain(layout, m_bounds.get(), placement);
  TeSeamlessSelection selection;
  TeSeamlessLists lists;
  TeSelectionFigures figures;
  std::vector<double> times;
  double allMs = 0, plainMs = 0;
  for (int frame = 0; frame < m_frames; frame++) {
    const TeLodView view = m_flight.view(frame).lodView();
    if (*windows) // the whole of it for the first frame, then a megabyte for each
      (*windows)->update({view.eye.x / placement.spacing, view.eye.y / placement.spacing},
                         layout.resolutionLog(), frame == 0 ? 0 : 1 << 20);
    const TeClipResidency* residency = *windows ? &(*windows)->residency() : nullptr;
    times.push_back(leastMs([&] {
      selector.select(view, placement, accuracy, residency, selection);
      lists.build(selection, layout, whole);
    }));
    if (*windows)
      (*windows)->clearUploads();
    plainMs += leastMs([&] { plain.run(view, precision); });
    allMs += times.back();
    figures.triangles += double(selection.triangles) / m_frames;
    figures.patches += double(selection.patches.size()) / m_frames;
    figures.visited += double(selection.traversed) / m_frames;
    figures.plainVisited += double(plain.visited()) / m_frames;
    figures.drawCalls[0] += double(lists.draws().size()) / m_frames;
    lists.build(selection, layout, parts);
    figures.drawCalls[1] += double(lists.draws().size()) / m_frames;
    figures.drawCalls[2] += double(lists.instances().size()) / m_frames;
    progress(frame + 1);
  }
  figures.nsPerPatch = 1e6 * allMs / (figures.visited * m_frames);
  figures.plainNsPerPatch = 1e6 * plainMs / (figures.plainVisited * m_frames);
  figures.ms = TeSpread::of(std::move(times));
  return figures;
}

TeResult<TeByWay<TeDrawingFigures>> TeInstancingSweep::draw(double precision, TeFlightStage& stage,
                                                            const Progress& progress) const {
  constexpr int kMostLoadingFrames = 200;
  std::vector<Drawn> ways;
  for (const TeInstancingWay way : kTeInstancingWays)
    ways.emplace_back(m_terrain.node(m_bounds->layout()), way, precision, m_frames);
  for (Drawn& drawn : ways) {
    TeResult<bool> loading = true;
    for (int i = 0; loading && *loading && i < kMostLoadingFrames; i++)
      loading = drawn.prepare(stage, m_flight.view(0));
    if (!loading)
      return loading.error();
  }
  for (int frame = 0; frame < m_frames; frame++) {
    for (Drawn& drawn : ways)
      if (const TeStatus ok = drawn.draw(stage, m_flight.view(frame)); !ok)
        return ok.error();
    progress(frame + 1);
  }
  return TeByWay<TeDrawingFigures>{ways[0].figures(), ways[1].figures(), ways[2].figures()};
}
