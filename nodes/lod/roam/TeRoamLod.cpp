#include "nodes/lod/roam/TeRoamLod.h"

#include "nodes/lod/roam/TeRoamFan.h"

#include <algorithm>
#include <limits>

namespace {

constexpr double kExactStep = 1.0 / 64; ///< pixels: TeLodSelection::coarsening
constexpr double kCoarsest = 1e12;
constexpr double kLargestWanted = 1e37;
constexpr double kFewest = 0.97; ///< of the wanted number of triangles, before more are made
/// By so much a triangle is more important than one that is merged for it; else the same two would take turns
/// while the camera trembles.
constexpr float kHysteresis = 1.1f;
constexpr int kChangesAtOnce = 16; ///< between looks at the clock

bool isSame(const TeLodView& a, const TeLodView& b) {
  return a.eye == b.eye && a.perspective == b.perspective && a.focal == b.focal && a.slack == b.slack &&
         a.planeCount == b.planeCount &&
         std::equal(a.planes.begin(), a.planes.begin() + a.planeCount, b.planes.begin());
}

} // namespace

std::unique_ptr<TeRoamLod> TeRoamLod::create(TeLodFieldPtr field, const Settings& settings) {
  std::shared_ptr<const TeRoamBounds> bounds =
      TeRoamBounds::create(field, settings.metric != TeRoamMetric::ScreenError);
  return std::make_unique<TeRoamLod>(std::move(bounds), std::move(field), settings);
}

TeRoamLod::TeRoamLod(std::shared_ptr<const TeRoamBounds> bounds, TeLodFieldPtr shared,
                     const Settings& settings)
    : TeLodMethod(std::move(shared)), m_bounds(bounds),
      m_settings(settings), m_dial{"triangles", true, 2, 2.0 * field().cells() * field().cells()},
      m_mesh(std::move(bounds), settings.metric, !settings.splitOnly) {}

double TeRoamLod::bytesPerSample() const {
  const double samples = double(field().cells() + 1) * double(field().cells() + 1);
  return sizeof(float) +
         double(m_bounds->bytes() + m_mesh.bytes() +
                (m_indices.capacity() + m_leaves.capacity()) * sizeof(std::uint32_t) + m_marks.capacity()) /
             samples;
}

bool TeRoamLod::continues(const TeLodView& view, const TeLodAccuracy& accuracy) const {
  return !m_isFirst && isSame(view, m_view) && accuracy.pixelError == m_accuracy.pixelError &&
         accuracy.dial == m_accuracy.dial && accuracy.maxTriangles == m_accuracy.maxTriangles;
}

void TeRoamLod::choose(const TeLodView& view, const TeLodAccuracy& accuracy, TeAllowance& allowance,
                       TeLodSelection& selection) {
  const bool byCount = accuracy.dial > 0;
  if (!continues(view, accuracy)) {
    if (m_settings.splitOnly)
      m_mesh.reset();
    const bool isExact = !byCount && accuracy.pixelError == 0;
    m_mesh.setView(view, isExact ? std::numeric_limits<float>::min() : 0.0f);
    m_floor = 0;
    m_isFirst = m_isComplete = false;
    m_view = view;
    m_accuracy = accuracy;
  }
  if (!m_isComplete) {
    Goal goal;
    goal.wanted = byCount ? 0 : std::min(accuracy.pixelError * m_mesh.unitsPerPixel(), kLargestWanted);
    goal.triangles = accuracy.maxTriangles;
    if (byCount) {
      goal.triangles = std::min(goal.triangles, std::int64_t(accuracy.dial));
      goal.fills = double(m_mesh.drawn()) < kFewest * double(goal.triangles);
    }
    m_isComplete = refine(goal, allowance, selection);
  }

  selection.complete = m_isComplete;
  selection.triangles = m_mesh.drawn();
  if (selection.triangles > 0)
    selection.parts.push_back({m_mesh.version(), selection.triangles});
  selection.visited = m_mesh.nodes().live();
  selection.culled = m_mesh.culled();
  selection.errorBound = m_mesh.errorBound();
  selection.dial = byCount ? accuracy.dial : double(selection.triangles);
  const double wanted = std::max(accuracy.pixelError, kExactStep);
  if (!byCount && m_isComplete && m_settings.metric == TeRoamMetric::ScreenError)
    selection.coarsening = std::clamp(selection.errorBound / wanted, 1.0, kCoarsest);
}

bool TeRoamLod::refine(const Goal& goal, TeAllowance& allowance, TeLodSelection& selection) {
  const int changesAtOnce = allowance.countsUnits() ? 1 : kChangesAtOnce;
  int changes = 0;
  for (;;) {
    const Step step = next(goal);
    if (step == Step::Done)
      return true;
    if (step == Step::Split) {
      const int done = m_mesh.split(m_mesh.splits().top());
      selection.splits += done;
      changes += done;
    } else {
      m_floor = std::max(m_floor, m_mesh.merges().topPriority());
      m_mesh.merge(m_mesh.merges().top());
      selection.merges++;
      changes++;
    }
    m_mergesNext = step == Step::Split;
    if (changes < changesAtOnce)
      continue;
    if (!allowance.spend(changes))
      return next(goal) == Step::Done;
    changes = 0;
  }
}

// Ends: what was merged is at most as important as m_floor, and only what is more important than that is
// split, except as a neighbour of that; so nothing is split twice.
TeRoamLod::Step TeRoamLod::next(const Goal& goal) const {
  const TeRoamQueue &splits = m_mesh.splits(), &merges = m_mesh.merges();
  if (m_mesh.drawn() > goal.triangles)
    return merges.empty() ? Step::Done : Step::Merge;
  const bool isNeeded =
      !splits.empty() && double(splits.topPriority()) > goal.wanted && splits.topPriority() > m_floor;
  const bool isUnneeded = !merges.empty() && double(merges.topPriority()) <= goal.wanted;
  if (isNeeded && goal.fills && m_mesh.drawn() + m_mesh.growth(splits.top()) <= goal.triangles)
    return isUnneeded && m_mergesNext ? Step::Merge : Step::Split;
  if (isUnneeded)
    return Step::Merge;
  if (isNeeded && !merges.empty() && splits.topPriority() > kHysteresis * merges.topPriority())
    return Step::Split;
  return Step::Done;
}

// No branch depends on a triangle, which could not be foretold: leaves in view are listed, their vertices
// marked and numbered, and four triangles written for each, of which the next leaf overwrites those that it
// has not.
void TeRoamLod::appendPart(std::size_t, TeLodMesh& mesh) const {
  constexpr std::size_t kMostIndices = 12;
  const TeRoamNodes& nodes = m_mesh.nodes();
  const std::vector<TeLodVertex>& vertices = nodes.vertices();
  m_leaves.resize(nodes.size());
  std::size_t leaves = 0;
  for (std::size_t node = 0; node < nodes.size(); node++) {
    m_leaves[leaves] = std::int32_t(node);
    leaves += std::size_t(m_mesh.isShown(std::int32_t(node)));
  }

  m_marks.assign(vertices.size(), 0);
  for (std::size_t i = 0; i < leaves; i++)
    for (const std::int32_t vertex : nodes.points(m_leaves[i]).vertices)
      m_marks[std::size_t(vertex)] = 1;
  m_indices.resize(vertices.size());
  std::size_t count = mesh.vertices.size();
  mesh.vertices.resize(count + vertices.size());
  for (std::size_t vertex = 0; vertex < vertices.size(); vertex++) {
    mesh.vertices[count] = vertices[vertex];
    m_indices[vertex] = std::uint32_t(count);
    count += m_marks[vertex];
  }
  mesh.vertices.resize(count);

  const std::size_t end = mesh.indices.size() + 3 * std::size_t(m_mesh.drawn());
  std::size_t next = mesh.indices.size();
  mesh.indices.resize(end + kMostIndices);
  for (std::size_t i = 0; i < leaves; i++) {
    const TeRoamPoints& points = nodes.points(m_leaves[i]);
    std::uint32_t indices[6];
    for (int k = 0; k < 6; k++)
      indices[k] = m_indices[std::size_t(points.vertices[k])];
    const TeRoamFan& fan = TeRoamFan::all()[points.edges];
    std::uint32_t* const out = mesh.indices.data() + next;
    for (std::size_t corner = 0; corner < kMostIndices; corner++)
      out[corner] = indices[fan.triangles[corner / 3][corner % 3]];
    next += 3 * std::size_t(fan.count);
  }
  mesh.indices.resize(end);
}
