#include "nodes/lod/roam/TeRoamMesh.h"

#include "nodes/lod/roam/TeRoamFan.h"
#include "patchdb/TeTargetClones.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <limits>

namespace {

constexpr std::int64_t kMostFree = 3; ///< times the triangles that exist
constexpr std::int64_t kFewest = 1024;

struct Counts {
  std::int64_t drawn = 0;
  std::int64_t culled = 0;
  bool changed = false;
};

/// Adds up what is in view and remembers it in `shown`.
TE_TARGET_CLONES
void count(const float* screen, const float* error, const std::uint8_t* fans, std::uint8_t* shown, int nodes,
           Counts& counts) {
  std::int32_t drawn = 0, culled = 0, changes = 0;
  for (int i = 0; i < nodes; i++) {
    const int seen = screen[i] >= 0 ? 1 : 0;
    drawn += seen ? fans[i] : 0;
    culled += (error[i] >= 0 ? 1 : 0) & (1 - seen);
    changes |= fans[i] != 0 ? seen ^ shown[i] : 0;
    shown[i] = std::uint8_t(seen);
  }
  counts = {drawn, culled, changes != 0};
}

} // namespace

TeRoamMesh::TeRoamMesh(std::shared_ptr<const TeRoamBounds> bounds, TeRoamMetric metric, bool keepsMerges)
    : m_metric(metric), m_keepsMerges(keepsMerges), m_nodes(std::move(bounds)) {
  assert(metric == TeRoamMetric::ScreenError || m_nodes.bounds().hasVariance());
  reset();
}

void TeRoamMesh::reset() {
  m_nodes.reset();
  m_splits.clear();
  m_merges.clear();
  const std::size_t size = m_nodes.size();
  m_screen.assign(size, -1.0f);
  m_fans.assign(size, 0);
  m_shown.assign(size, 0);
  if (m_metric != TeRoamMetric::ScreenError)
    m_document.assign(size, 0.0f);
  for (const std::int32_t base : {0, 1}) {
    m_fans[std::size_t(base)] = 1;
    m_splits.insert(base, m_nodes[base].number, 0);
  }
  m_drawn = 0;
  m_version++;
}

// The same splits again, level by level, so that none forces another.
void TeRoamMesh::compact() {
  std::vector<std::uint32_t> split;
  for (std::int32_t node = 0; node < std::int32_t(m_nodes.size()); node++)
    if (m_nodes.boxes().error[std::size_t(node)] >= 0 && !m_nodes[node].isLeaf())
      split.push_back(m_nodes[node].number);
  std::sort(split.begin(), split.end());
  reset();
  std::vector<std::int32_t> open = {0, 1};
  for (std::size_t i = 0; i < open.size(); i++) {
    if (!std::binary_search(split.begin(), split.end(), m_nodes[open[i]].number))
      continue;
    this->split(open[i]);
    for (int k = 0; k < 4; k++)
      open.push_back(m_nodes[open[i]].children + k);
  }
}

void TeRoamMesh::setView(const TeLodView& view, float least) {
  if (std::int64_t(m_nodes.size()) > kFewest + (1 + kMostFree) * m_nodes.live())
    compact();
  const TeLodField& field = m_nodes.bounds().field();
  m_view.emplace(field, view, least);
  m_camera = view;
  m_least = least;
  m_unitsPerPixel = m_metric == TeRoamMetric::ScreenError ? 1 : 1 / view.focal;
  if (m_metric == TeRoamMetric::ScaledVariance)
    m_unitsPerPixel *= 2 * field.spacing() * field.cells();
  m_view->priorities(m_nodes.boxes(), 0, m_nodes.size(), m_screen.data());
  if (m_metric != TeRoamMetric::ScreenError) {
    applyFormula(0, std::numeric_limits<float>::max());
    applyFormulaBelow(0);
    applyFormulaBelow(1);
  }
  m_splits.refresh(priorities());
  m_merges.refresh(priorities());
  Counts counts;
  count(m_screen.data(), m_nodes.boxes().error.data(), m_fans.data(), m_shown.data(), int(m_nodes.size()),
        counts);
  m_drawn = counts.drawn;
  m_culled = counts.culled;
  m_version += counts.changed;
}

void TeRoamMesh::measure(std::int32_t first, std::size_t count) {
  m_view->priorities(m_nodes.boxes(), std::size_t(first), count, m_screen.data() + first);
}

// Of four triangles. Not more than `most`, their parent's: so that what is more important than its parent by
// this formula is not split before it is there.
void TeRoamMesh::applyFormula(std::int32_t first, float most) {
  for (std::int32_t node = first; node < first + 4; node++)
    m_document[std::size_t(node)] = isSeen(node) ? std::min(most, std::max(m_least, formula(node))) : -1.0f;
}

void TeRoamMesh::applyFormulaBelow(std::int32_t node) {
  if (m_nodes[node].isLeaf())
    return;
  const std::int32_t children = m_nodes[node].children;
  applyFormula(children, m_document[std::size_t(node)]);
  for (int k = 0; k < 4; k++)
    applyFormulaBelow(children + k);
}

float TeRoamMesh::formula(std::int32_t node) const {
  const TeLodField& field = m_nodes.bounds().field();
  glm::dvec3 centroid(0);
  for (int k = 0; k < 3; k++)
    centroid += field.position(m_nodes.vertices()[std::size_t(m_nodes.points(node).vertices[k])]) / 3.0;
  const double pixels = m_camera.pixels(double(m_nodes.variances()[std::size_t(node)]) * field.heightScale(),
                                        glm::distance(centroid, m_camera.eye));
  return float(std::min(pixels * m_unitsPerPixel, double(std::numeric_limits<float>::max())));
}

int TeRoamMesh::split(std::int32_t leaf) {
  int done = 1;
  for (int edge = 0; edge < 3; edge++)
    if (m_nodes[leaf].neighbours[edge] == TeRoamNode::kNone)
      done += split(m_nodes[m_nodes[leaf].parent].neighbours[edge]);

  m_splits.remove(leaf);
  lockNeeded(leaf, 1);
  const std::int32_t first = m_nodes.makeChildren(leaf);
  if (m_nodes.size() > m_screen.size()) {
    m_screen.resize(m_nodes.size(), -1.0f);
    m_fans.resize(m_nodes.size(), 0);
    m_shown.resize(m_nodes.size(), 0);
    if (m_metric != TeRoamMetric::ScreenError)
      m_document.resize(m_nodes.size(), 0.0f);
  }
  measure(first, 4);
  if (m_metric != TeRoamMetric::ScreenError)
    applyFormula(first, m_document[std::size_t(leaf)]);
  setFan(leaf);
  for (const std::int32_t neighbour : m_nodes[leaf].neighbours)
    if (neighbour >= 0)
      setFan(neighbour);
  const bool areLeast = m_nodes[first].triangle.level == m_nodes.deepest();
  for (std::int32_t child = first; child < first + 4; child++) {
    m_shown[std::size_t(child)] = isSeen(child);
    setFan(child);
    if (!areLeast)
      m_splits.insert(child, m_nodes[child].number, priority(child));
  }
  if (m_keepsMerges)
    m_merges.insert(leaf, m_nodes[leaf].number, priority(leaf));
  m_version++;
  return done;
}

void TeRoamMesh::merge(std::int32_t node) {
  assert(!m_nodes[node].isLeaf() && m_nodes[node].locks == 0);
  const std::int32_t first = m_nodes[node].children;
  const bool areLeast = m_nodes[first].triangle.level == m_nodes.deepest();
  for (std::int32_t child = first; child < first + 4; child++) {
    if (!areLeast)
      m_splits.remove(child);
    if (isSeen(child))
      m_drawn -= m_fans[std::size_t(child)];
    m_fans[std::size_t(child)] = 0;
    m_screen[std::size_t(child)] = -1;
  }
  m_merges.remove(node);
  m_nodes.freeChildren(node);
  setFan(node);
  for (const std::int32_t neighbour : m_nodes[node].neighbours)
    if (neighbour >= 0)
      setFan(neighbour);
  m_splits.insert(node, m_nodes[node].number, priority(node));
  lockNeeded(node, -1);
  m_version++;
}

std::int64_t TeRoamMesh::growth(std::int32_t leaf) const {
  m_collected.clear();
  collectSplits(leaf);
  return 6 * std::int64_t(m_collected.size());
}

// Some are needed by two others; they are few.
void TeRoamMesh::collectSplits(std::int32_t leaf) const {
  if (std::find(m_collected.begin(), m_collected.end(), leaf) != m_collected.end())
    return;
  m_collected.push_back(leaf);
  for (int edge = 0; edge < 3; edge++)
    if (m_nodes[leaf].neighbours[edge] == TeRoamNode::kNone)
      collectSplits(m_nodes[m_nodes[leaf].parent].neighbours[edge]);
}

void TeRoamMesh::setFan(std::int32_t number) {
  const TeRoamNode& node = m_nodes[number];
  const int fan = node.isLeaf() ? TeRoamFan::all()[m_nodes.points(number).edges].count : 0;
  std::uint8_t& before = m_fans[std::size_t(number)];
  if (isSeen(number))
    m_drawn += fan - before;
  before = std::uint8_t(fan);
}

// What a split node needs to stay split: its parent and, for its own neighbours to exist, theirs.
void TeRoamMesh::lockNeeded(std::int32_t number, int change) {
  const TeRoamNode& node = m_nodes[number];
  if (node.parent < 0)
    return;
  changeLocks(node.parent, change);
  for (int edge = 0; edge < 3 && node.childNumber < 3; edge++) {
    const std::int32_t neighbour = m_nodes[node.parent].neighbours[edge];
    if (edge != (node.childNumber + 1) % 3 && neighbour >= 0)
      changeLocks(neighbour, change);
  }
}

void TeRoamMesh::changeLocks(std::int32_t number, int change) {
  TeRoamNode& node = m_nodes[number];
  const bool wasFree = node.locks == 0;
  node.locks = std::uint8_t(node.locks + change);
  if (!m_keepsMerges || wasFree == (node.locks == 0))
    return;
  if (wasFree)
    m_merges.remove(number);
  else
    m_merges.insert(number, node.number, priority(number));
}

double TeRoamMesh::errorBound() const {
  float worst = 0;
  if (m_metric == TeRoamMetric::ScreenError) {
    worst = m_splits.empty() ? 0 : m_splits.topPriority();
  } else {
    for (std::size_t node = 0; node < m_screen.size(); node++)
      if (m_fans[node] > 0 && m_nodes.boxes().error[node] > 0)
        worst = std::max(worst, m_screen[node]);
  }
  return worst < std::numeric_limits<float>::max() ? double(worst) : std::numeric_limits<double>::infinity();
}

std::size_t TeRoamMesh::bytes() const {
  return m_nodes.bytes() + m_splits.bytes() + m_merges.bytes() +
         (m_screen.capacity() + m_document.capacity()) * sizeof(float) + m_fans.capacity() +
         m_shown.capacity();
}
