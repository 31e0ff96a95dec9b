#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>

using Sides = TeQuadtreeSides;

TeQuadtreeMesh::TeQuadtreeMesh(const TeQuadtree& tree, const TeLodField::Placement& placement)
    : m_tree(&tree), m_placement(placement) {
  clear();
}

void TeQuadtreeMesh::clear() {
  m_vertices.assign(1, Vertex{});
  m_squares.assign(1, Square{});
  m_freeVertices.clear();
  m_freeSquares.clear();
  m_drawn.clear();
  m_lastDrawn.clear();
  m_parts.clear();
  m_ranges.assign(std::size_t(kPartsPerSide) * kPartsPerSide + 1, Range());
  m_lastRanges = m_ranges;
  m_frame = 0;
  m_heightsVersion = m_tree->heightsVersion();
  const TeQuadtreePlace place = m_tree->root();
  for (int k = 0; k < 4; k++)
    m_squares[0].corners[k] = makeVertex(Sides::isEast(k) ? place.side() : 0,
                                         Sides::isNorth(k) ? place.side() : 0, place.corners[k]);
  m_squares[0].vertices[kCentre] = makeVertex(place.half(), place.half(), m_tree->square(0).centre);
  m_squares[0].sideLog = std::uint8_t(place.sideLog);
}

std::size_t TeQuadtreeMesh::bytes() const {
  const auto of = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return of(m_vertices) + of(m_squares) + of(m_freeVertices) + of(m_freeSquares) + of(m_tasks) + of(m_drawn) +
         of(m_lastDrawn) + of(m_large) + of(m_parts) + of(m_ranges) + of(m_lastRanges) + of(m_numbers);
}

const TeQuadtreeMesh::Result& TeQuadtreeMesh::update(const TeLodView& view, const Wish& wish) {
  if (m_heightsVersion != m_tree->heightsVersion())
    clear();
  m_metric = TeQuadtreeMetric(view, m_placement, double(m_tree->side()));
  m_metric.setRange(m_tree->square(0).low(), m_tree->square(0).high());
  m_wish = wish;
  m_result = Result();
  m_worst2 = m_worstOffset = 0;
  const double wanted = wish.threshold > 0 ? view.focal / wish.threshold : wish.pixelError;
  m_wanted2 = wanted * wanted * (wish.geomorph ? kMorphShare * kMorphShare : 1);
  m_metric.setMorph(wish.geomorph ? morphPixels() : 0);
  m_frame++;
  std::swap(m_drawn, m_lastDrawn);
  std::swap(m_ranges, m_lastRanges);
  m_drawn.clear();
  m_large.clear();
  m_parts.clear();
  m_ranges.assign(m_lastRanges.size(), Range());

  Square& root = m_squares[0];
  root.mark = m_frame;
  root.tested = root.edges = 0;
  root.planes = std::uint8_t(m_metric.cut(boxOf(root, 0), m_metric.allPlanes()));
  m_tasks.assign(1, kCentre);
  for (std::size_t task = 0; task < m_tasks.size(); task++) {
    const std::uint32_t number = m_tasks[task] >> 3;
    const int what = int(m_tasks[task] & 7);
    if (what == kCentre) {
      for (int s = 0; s < 4; s++)
        testEdge(number, s);
      for (int k = 0; wish.threshold > 0 && k < 4; k++)
        testChild(number, k);
    } else if (!(wish.threshold > 0)) {
      testChild(number, what);
      testChild(number, Sides::previous(what));
    }
  }
  settle(0);

  const bool wasMorphed = m_morphed;
  m_morphed = wish.geomorph;
  m_result.errorBound = std::sqrt(m_worst2) + m_worstOffset;
  if (!(wish.threshold > 0))
    m_result.errorBound = std::min(m_result.errorBound, wanted); // but for rounding, it is that at most
  drawTogether(m_morphed || wasMorphed);
  return m_result;
}

std::uint32_t TeQuadtreeMesh::enableSquare(std::uint32_t parent, int k) {
  std::uint32_t number = m_squares[parent].children[k];
  if (isMarked(number))
    return number;
  enableEdge(parent, k);
  enableEdge(parent, Sides::next(k));
  if (number == 0)
    number = makeSquare(parent, k);
  const unsigned planes = m_squares[parent].planes;
  Square& square = m_squares[number];
  square.mark = m_frame;
  square.data = m_tree->child(m_squares[parent].data, k); // it may have been dropped and made again
  assert(square.data != 0);
  square.tested = square.edges = 0;
  const bool isCut = planes != 0 && planes != TeQuadtreeMetric::kOutside;
  square.planes = std::uint8_t(isCut ? m_metric.cut(boxOf(square, square.data), planes) : planes);
  m_tasks.push_back(number << 3 | kCentre);
  m_tree->prefetchChildren(square.data); // tasks are done in the order in which they come up
  return number;
}

void TeQuadtreeMesh::enableEdge(std::uint32_t number, int s) {
  if ((m_squares[number].edges >> s & 1) != 0)
    return;
  std::uint32_t neighbour = 0;
  if (number != 0) {
    const std::uint32_t parent = m_squares[number].parent;
    const int quadrant = m_squares[number].quadrant;
    const bool inside = !Sides::touches(quadrant, s);
    const std::uint32_t outside = inside ? parent : m_squares[parent].neighbours[s];
    if (inside || outside != 0)
      neighbour = enableSquare(outside, Sides::mirrored(quadrant, s));
  }
  Square& square = m_squares[number];
  const int opposite = Sides::opposite(s);
  if (square.vertices[s] == 0) {
    const std::int32_t half = (1 << square.sideLog) / 2;
    square.vertices[s] =
        makeVertex(square.x + half * (1 + Sides::kX[s]), square.y + half * (1 + Sides::kY[s]),
                   m_tree->square(square.data).edge[s]);
    if (neighbour != 0)
      m_squares[neighbour].vertices[opposite] = square.vertices[s];
  }
  square.edges = std::uint8_t(square.edges | 1 << s);
  m_tasks.push_back(number << 3 | std::uint32_t(s));
  if (neighbour != 0) {
    m_squares[neighbour].edges = std::uint8_t(m_squares[neighbour].edges | 1 << opposite);
    m_tasks.push_back(neighbour << 3 | std::uint32_t(opposite));
  }
}

std::uint32_t TeQuadtreeMesh::makeVertex(std::int32_t column, std::int32_t row, float height) {
  std::uint32_t number = std::uint32_t(m_vertices.size());
  if (m_freeVertices.empty()) {
    m_vertices.emplace_back();
  } else {
    number = m_freeVertices.back();
    m_freeVertices.pop_back();
  }
  m_vertices[number] = {column, row, height, 0, height, 1, 0};
  m_result.enabled++;
  return number;
}

std::uint32_t TeQuadtreeMesh::makeSquare(std::uint32_t parentNumber, int k) {
  std::uint32_t number = std::uint32_t(m_squares.size());
  if (m_freeSquares.empty()) {
    m_squares.emplace_back();
  } else {
    number = m_freeSquares.back();
    m_freeSquares.pop_back();
  }
  Square& parent = m_squares[parentNumber];
  Square& square = m_squares[number];
  square = Square{};
  square.parent = parentNumber;
  square.quadrant = std::uint8_t(k);
  square.sideLog = std::uint8_t(parent.sideLog - 1);
  const std::int32_t side = 1 << square.sideLog;
  square.x = parent.x + (Sides::isEast(k) ? side : 0);
  square.y = parent.y + (Sides::isNorth(k) ? side : 0);
  square.corners[k] = parent.corners[k];
  square.corners[Sides::next(k)] = parent.vertices[Sides::next(k)];
  square.corners[Sides::opposite(k)] = parent.vertices[kCentre];
  square.corners[Sides::previous(k)] = parent.vertices[k];
  m_vertices[parent.vertices[k]].users++;
  m_vertices[parent.vertices[Sides::next(k)]].users++;
  parent.children[k] = number;
  for (int s = 0; s < 4; s++) {
    const int across = Sides::mirrored(k, s);
    const std::uint32_t outside = parent.neighbours[s];
    const std::uint32_t neighbour = !Sides::touches(k, s) ? parent.children[across]
                                    : outside != 0        ? m_squares[outside].children[across]
                                                          : 0;
    square.neighbours[s] = neighbour;
    if (neighbour != 0)
      m_squares[neighbour].neighbours[Sides::opposite(s)] = number;
  }
  const float height = m_tree->square(m_tree->child(parent.data, k)).centre;
  const std::uint32_t centre = makeVertex(square.x + side / 2, square.y + side / 2, height);
  m_squares[number].vertices[kCentre] = centre;
  return number;
}

/// What was not enabled in this frame goes; what was is drawn, parents first.
void TeQuadtreeMesh::settle(std::uint32_t number) {
  for (int k = 0; k < 4; k++) {
    const std::uint32_t child = m_squares[number].children[k];
    if (child != 0 && m_squares[child].mark != m_frame)
      removeSquare(child);
  }
  for (int s = 0; s < 4; s++)
    if ((m_squares[number].edges >> s & 1) == 0)
      removeEdge(number, s);
  m_result.visited++;
  if (m_squares[number].planes == TeQuadtreeMetric::kOutside)
    m_result.culled++;
  else
    draw(number);
  for (const std::uint32_t child : m_squares[number].children)
    if (child != 0)
      settle(child);
}

void TeQuadtreeMesh::removeSquare(std::uint32_t number) {
  for (const std::uint32_t child : m_squares[number].children)
    if (child != 0)
      removeSquare(child);
  for (int s = 0; s < 4; s++)
    removeEdge(number, s);
  Square& square = m_squares[number];
  Square& parent = m_squares[square.parent];
  for (int s = 0; s < 4; s++)
    if (square.neighbours[s] != 0)
      m_squares[square.neighbours[s]].neighbours[Sides::opposite(s)] = 0;
  m_vertices[parent.vertices[square.quadrant]].users--;
  m_vertices[parent.vertices[Sides::next(square.quadrant)]].users--;
  parent.children[square.quadrant] = 0;
  m_freeVertices.push_back(square.vertices[kCentre]);
  m_result.disabled++;
  m_freeSquares.push_back(number);
}

/// Disables the middle of an edge that was not enabled in this frame. While squares on the other side use it
/// still, it waits until they are gone.
void TeQuadtreeMesh::removeEdge(std::uint32_t number, int s) {
  Square& square = m_squares[number];
  const std::uint32_t vertex = square.vertices[s];
  if (vertex == 0 || m_vertices[vertex].users != 0)
    return;
  square.vertices[s] = 0;
  if (square.neighbours[s] != 0)
    m_squares[square.neighbours[s]].vertices[Sides::opposite(s)] = 0;
  m_freeVertices.push_back(vertex);
  m_result.disabled++;
}
