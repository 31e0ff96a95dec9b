#include "nodes/lod/roam/TeRoamNodes.h"

#include <cassert>

TeRoamNodes::TeRoamNodes(std::shared_ptr<const TeRoamBounds> bounds) : m_bounds(std::move(bounds)) {
  reset();
}

std::size_t TeRoamNodes::bytes() const {
  return m_nodes.capacity() * sizeof(TeRoamNode) + m_points.capacity() * sizeof(TeRoamPoints) +
         m_boxes.bytes() + m_variances.capacity() * sizeof(float) +
         m_vertices.capacity() * sizeof(TeLodVertex) +
         (m_freeFours.capacity() + m_freeVertices.capacity()) * sizeof(std::int32_t);
}

void TeRoamNodes::reset() {
  m_nodes.clear();
  m_points.clear();
  m_boxes.resize(0);
  m_vertices.clear();
  m_freeFours.clear();
  m_freeVertices.clear();
  const std::int32_t base = takeFour();
  const int cellsLog = deepest();
  m_live = 2;
  // South-west, south-east, north-east, north-west.
  const TeRoamTriangle lower{0, 0, 0, false}, upper{0, 0, 0, true};
  for (const TeRoamTriangle::Point& point : {lower.corner(0, cellsLog), lower.corner(1, cellsLog),
                                             lower.corner(2, cellsLog), upper.corner(1, cellsLog)})
    makeVertex(point);
  for (const bool isUpper : {false, true}) {
    const std::int32_t number = base + (isUpper ? 1 : 0);
    TeRoamNode& node = m_nodes[std::size_t(number)];
    node.triangle = isUpper ? upper : lower;
    node.number = node.triangle.number();
    node.neighbours[0] = node.neighbours[1] = TeRoamNode::kRim;
    node.neighbours[2] = isUpper ? base : base + 1;
    const std::int32_t vertices[2][3] = {{0, 1, 2}, {2, 3, 0}};
    for (std::size_t k = 0; k < 3; k++)
      m_points[std::size_t(number)].vertices[k] = vertices[isUpper ? 1 : 0][k];
    describe(number);
  }
}

std::int32_t TeRoamNodes::takeFour() {
  if (!m_freeFours.empty()) {
    const std::int32_t first = m_freeFours.back();
    m_freeFours.pop_back();
    return first;
  }
  const auto first = std::int32_t(m_nodes.size());
  m_nodes.resize(m_nodes.size() + 4);
  m_points.resize(m_nodes.size());
  m_boxes.resize(m_nodes.size());
  if (m_bounds->hasVariance())
    m_variances.resize(m_nodes.size());
  return first;
}

std::int32_t TeRoamNodes::makeVertex(const TeRoamTriangle::Point& point) {
  const TeLodVertex vertex = m_bounds->field().vertex(point.column, point.row);
  if (m_freeVertices.empty()) {
    m_vertices.push_back(vertex);
    return std::int32_t(m_vertices.size()) - 1;
  }
  const std::int32_t place = m_freeVertices.back();
  m_freeVertices.pop_back();
  m_vertices[std::size_t(place)] = vertex;
  return place;
}

void TeRoamNodes::describe(std::int32_t number) {
  const TeRoamNode& node = (*this)[number];
  const TeRoamBound bound = m_bounds->bound(node.triangle, node.number);
  const int log = deepest() - node.triangle.level;
  const auto place = std::size_t(number);
  m_boxes.x[place] = float(node.triangle.x << log);
  m_boxes.y[place] = float(node.triangle.y << log);
  m_boxes.size[place] = float(1 << log);
  m_boxes.low[place] = bound.low;
  m_boxes.high[place] = bound.high;
  m_boxes.error[place] = bound.error;
  if (m_bounds->hasVariance())
    m_variances[place] = m_bounds->variance(node.triangle, node.number);
}

std::int32_t TeRoamNodes::makeChildren(std::int32_t parentNumber) {
  const std::int32_t first = takeFour();
  TeRoamNode& parent = (*this)[parentNumber];
  assert(parent.isLeaf() && parent.triangle.level < deepest());
  parent.children = first;
  m_live += 4;

  const TeRoamPoints& points = m_points[std::size_t(parentNumber)];
  std::int32_t middles[3];
  for (int k = 0; k < 3; k++)
    middles[k] =
        points.edges >> k & 1 ? points.vertices[3 + k] : makeVertex(parent.triangle.middle(k, deepest()));
  const std::int32_t vertices[4][3] = {{points.vertices[0], middles[0], middles[2]},
                                       {middles[0], points.vertices[1], middles[1]},
                                       {middles[2], middles[1], points.vertices[2]},
                                       {middles[1], middles[2], middles[0]}};
  for (int k = 0; k < 4; k++) {
    TeRoamNode& child = (*this)[first + k];
    child = TeRoamNode();
    child.triangle = parent.triangle.child(k);
    child.number = TeRoamTriangle::childOf(parent.number, k);
    child.parent = parentNumber;
    child.childNumber = std::uint8_t(k);
    TeRoamPoints& corners = m_points[std::size_t(first + k)];
    corners.edges = 0;
    for (int corner = 0; corner < 3; corner++)
      corners.vertices[corner] = corners.vertices[3 + corner] = vertices[k][corner];
    describe(first + k);
  }
  linkChildren(parentNumber, middles);
  return first;
}

void TeRoamNodes::linkChildren(std::int32_t parentNumber, const std::int32_t (&middles)[3]) {
  const TeRoamNode& parent = (*this)[parentNumber];
  const std::int32_t first = parent.children;
  for (int edge = 0; edge < 3; edge++) {
    // The child in the middle has an edge with each of the others.
    const int across = (edge + 2) % 3;
    (*this)[first + 3].neighbours[edge] = first + across;
    (*this)[first + across].neighbours[edge] = first + 3;

    // The two children on an edge of the parent meet those of its neighbour the other way round.
    const int from = edge, to = (edge + 1) % 3;
    const std::int32_t neighbour = parent.neighbours[edge];
    if (neighbour < 0) {
      (*this)[first + from].neighbours[edge] = (*this)[first + to].neighbours[edge] = neighbour;
      continue;
    }
    TeRoamPoints& points = m_points[std::size_t(neighbour)];
    points.edges = std::uint8_t(points.edges | 1 << edge);
    points.vertices[3 + edge] = middles[edge];
    const TeRoamNode& other = (*this)[neighbour];
    if (other.isLeaf())
      continue;
    (*this)[first + from].neighbours[edge] = other.children + to;
    (*this)[first + to].neighbours[edge] = other.children + from;
    (*this)[other.children + to].neighbours[edge] = first + from;
    (*this)[other.children + from].neighbours[edge] = first + to;
  }
}

void TeRoamNodes::freeChildren(std::int32_t parentNumber) {
  TeRoamNode& parent = (*this)[parentNumber];
  const std::int32_t first = parent.children;
  for (int edge = 0; edge < 3; edge++) {
    const std::int32_t neighbour = parent.neighbours[edge];
    if (!(m_points[std::size_t(parentNumber)].edges >> edge & 1))
      m_freeVertices.push_back(m_points[std::size_t(first + 3)].vertices[(edge + 2) % 3]);
    if (neighbour < 0)
      continue;
    TeRoamPoints& points = m_points[std::size_t(neighbour)];
    points.edges = std::uint8_t(points.edges & ~(1 << edge));
    points.vertices[3 + edge] = points.vertices[edge];
    const TeRoamNode& other = (*this)[neighbour];
    if (other.isLeaf())
      continue;
    for (const int k : {edge, (edge + 1) % 3})
      (*this)[other.children + k].neighbours[edge] = TeRoamNode::kNone;
  }
  for (int k = 0; k < 4; k++)
    m_boxes.error[std::size_t(first + k)] = -1;
  m_freeFours.push_back(first);
  parent.children = TeRoamNode::kNone;
  m_live -= 4;
}
