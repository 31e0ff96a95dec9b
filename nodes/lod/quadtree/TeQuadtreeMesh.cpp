#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>

using Sides = TeQuadtreeSides;

namespace {

/// A side is one triangle, or two of which children cover some. Bits as in Drawn::shape.
std::uint32_t trianglesOf(std::uint32_t shape) {
  return std::uint32_t(4 + __builtin_popcount(shape & 15) - 2 * __builtin_popcount(shape >> 4 & 15));
}

} // namespace

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

TeQuadtreeBox TeQuadtreeMesh::boxOf(const Square& square, std::uint32_t number) const {
  const TeQuadtreeSquare& data = m_tree->square(number);
  const double x = square.x, y = square.y, side = double(1 << square.sideLog);
  return {x, x + side, y, y + side, data.low(), data.high()};
}

TeQuadtreeBox TeQuadtreeMesh::boxOfChild(const Square& square, int k, std::uint32_t number) const {
  const TeQuadtreeSquare& data = m_tree->square(number);
  const double half = double(1 << square.sideLog) / 2;
  const double x = square.x + (Sides::isEast(k) ? half : 0), y = square.y + (Sides::isNorth(k) ? half : 0);
  return {x, x + half, y, y + half, data.low(), data.high()};
}

/// Of the two triangles at an edge.
TeQuadtreeBox TeQuadtreeMesh::boxOfEdge(const Square& square, int s, std::uint32_t neighbour) const {
  TeQuadtreeBox box = boxOf(square, square.data);
  const double side = double(1 << square.sideLog), outward = neighbour != 0 ? side / 2 : 0;
  switch (s) {
  case Sides::kEast:
    box.x0 += side / 2, box.x1 += outward;
    break;
  case Sides::kNorth:
    box.y0 += side / 2, box.y1 += outward;
    break;
  case Sides::kWest:
    box.x1 -= side / 2, box.x0 -= outward;
    break;
  default:
    box.y1 -= side / 2, box.y0 -= outward;
    break;
  }
  if (neighbour != 0) {
    box.z0 = std::min(box.z0, m_tree->square(neighbour).low());
    box.z1 = std::max(box.z1, m_tree->square(neighbour).high());
  }
  return box;
}

/// Of the two triangles at an edge. It is kept by the square to the west, or north, of it.
double TeQuadtreeMesh::edgeError(const Square& square, int s, std::uint32_t neighbour) const {
  const TeQuadtreeSquare& own = m_tree->square(square.data);
  switch (s) {
  case Sides::kEast:
    return double(teUnpack(own.eastError));
  case Sides::kSouth:
    return double(teUnpack(own.southError));
  case Sides::kNorth:
    return neighbour != 0 ? double(teUnpack(m_tree->square(neighbour).southError))
                          : m_tree->rimError(s, square.x + (1 << square.sideLog) / 2);
  default:
    return neighbour != 0 ? double(teUnpack(m_tree->square(neighbour).eastError))
                          : m_tree->rimError(s, square.y + (1 << square.sideLog) / 2);
  }
}

/// The data of the square on the other side, enabled or not; 0: there is none.
std::uint32_t TeQuadtreeMesh::neighbourData(std::uint32_t number, int s) const {
  const Square& square = m_squares[number];
  const std::uint32_t neighbour = square.neighbours[s];
  if (isMarked(neighbour))
    return m_squares[neighbour].data;
  if (number == 0)
    return 0;
  const Square& parent = m_squares[square.parent];
  const int across = Sides::mirrored(square.quadrant, s);
  if (!Sides::touches(square.quadrant, s))
    return m_tree->child(parent.data, across);
  // The middle of this edge of the parent is enabled, so the parent's neighbour is, too.
  const std::uint32_t outside = parent.neighbours[s];
  return outside != 0 ? m_tree->child(m_squares[outside].data, across) : 0;
}

bool TeQuadtreeMesh::inView(const Square& square, const TeQuadtreeBox& box) const {
  return square.planes == 0 || m_metric.cut(box, m_metric.allPlanes()) != TeQuadtreeMetric::kOutside;
}

/// Whether triangles of a square that deviate by `error` are not good enough for where they are.
bool TeQuadtreeMesh::isTooFar(const Square& square, double error, const TeQuadtreeBox& box) {
  if (error == 0)
    return false;
  const double pixels2 = m_metric.pixels2(error, m_metric.distance2(box));
  const bool tooFar = pixels2 > m_wanted2;
  if ((!tooFar && pixels2 <= m_worst2) || !inView(square, box))
    return false;
  if (!tooFar)
    m_worst2 = pixels2;
  return tooFar;
}

/// By what is at hand: at a distance that is too short, triangles over a rectangle are no worse than others
/// are already. Spares most tests that fail their box and a division.
bool TeQuadtreeMesh::isGoodEnough(double error, double x0, double x1, double y0, double y1) const {
  return m_metric.pixels2(error, 1) <= m_worst2 * m_metric.leastDistance2(x0, x1, y0, y1);
}

void TeQuadtreeMesh::testEdge(std::uint32_t number, int s) {
  const Square& square = m_squares[number];
  if (square.planes == TeQuadtreeMetric::kOutside || (square.edges >> s & 1) != 0 ||
      !m_tree->square(square.data).hasSide(s))
    return;
  // A square tests its east and south edges; the others only where no square does.
  const bool isOwn = s == Sides::kEast || s == Sides::kSouth;
  const std::uint32_t beyond = square.neighbours[s];
  if (!isOwn && isMarked(beyond) && m_squares[beyond].planes != TeQuadtreeMetric::kOutside)
    return;
  if (isOwn && !(m_wish.threshold > 0)) {
    const TeQuadtreeSquare& data = m_tree->square(square.data);
    const double x = square.x, y = square.y, side = double(1 << square.sideLog), half = side / 2;
    const bool isGood =
        s == Sides::kEast
            ? isGoodEnough(double(teUnpack(data.eastError)), x + half, x + side + half, y, y + side)
            : isGoodEnough(double(teUnpack(data.southError)), x, x + side, y - half, y + half);
    if (isGood)
      return;
  }
  const std::uint32_t neighbour = neighbourData(number, s);
  const TeQuadtreeBox box = boxOfEdge(square, s, neighbour);
  bool enables = false;
  if (m_wish.threshold > 0) {
    const Vertex& a = m_vertices[square.corners[Sides::previous(s)]];
    const Vertex& b = m_vertices[square.corners[s]];
    const double height = double(m_tree->square(square.data).edge[s]);
    const double error = std::fabs(height - (double(a.height) + double(b.height)) / 2);
    const double x = (double(a.column) + b.column) / 2, y = (double(a.row) + b.row) / 2;
    enables =
        error * m_metric.heightScale() * m_wish.threshold > m_metric.maxNorm({x, x, y, y, height, height}) &&
        inView(square, box);
  } else {
    enables = isTooFar(square, edgeError(square, s, neighbour), box);
  }
  if (enables)
    enableEdge(number, s);
}

void TeQuadtreeMesh::testChild(std::uint32_t number, int k) {
  Square& square = m_squares[number];
  if (square.planes == TeQuadtreeMetric::kOutside || (square.tested >> k & 1) != 0)
    return;
  square.tested = std::uint8_t(square.tested | 1 << k);
  const std::uint32_t data = m_tree->child(square.data, k);
  if (data == 0 || isMarked(square.children[k]))
    return;
  const TeQuadtreeSquare& inside = m_tree->square(data);
  const double half = double(1 << square.sideLog) / 2;
  const double x = square.x + (Sides::isEast(k) ? half : 0), y = square.y + (Sides::isNorth(k) ? half : 0);
  const double error = double(teUnpack(inside.centreError));
  const bool usesDial = m_wish.threshold > 0;
  if (!usesDial && isGoodEnough(error, x, x + half, y, y + half))
    return;
  const TeQuadtreeBox box{x, x + half, y, y + half, inside.low(), inside.high()};
  const bool enables =
      usesDial ? double(teUnpack(inside.largestError)) * m_metric.heightScale() * m_wish.threshold >
                         m_metric.maxNorm(box) &&
                     inView(square, box)
               : isTooFar(square, error, box);
  if (enables)
    enableSquare(number, k);
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

void TeQuadtreeMesh::draw(std::uint32_t number) {
  const Square& square = m_squares[number];
  std::uint32_t enabled = square.edges;
  for (int k = 0; k < 4; k++)
    enabled |= std::uint32_t(square.children[k] != 0) << (4 + k);
  const std::uint32_t triangles = trianglesOf(enabled);
  m_result.triangles += triangles;
  const int partLog = m_tree->sideLog() - kPartDepth;
  const Drawn drawn{square.x, square.y, std::uint32_t(square.sideLog) << 8 | enabled, number};
  if (square.sideLog > partLog) {
    m_large.push_back(drawn);
  } else {
    if (square.sideLog == partLog) {
      const std::uint32_t place =
          std::uint32_t((square.y >> partLog) * kPartsPerSide + (square.x >> partLog));
      m_ranges[place].first = std::uint32_t(m_drawn.size());
      m_parts.push_back({place, 0, 0});
    }
    m_drawn.push_back(drawn);
    m_ranges[m_parts.back().place].count++;
    m_parts.back().triangles += triangles;
  }
  if (m_wish.threshold > 0)
    boundDrawn(number, enabled);
  if (m_wish.geomorph)
    morphSquare(number);
}

/// Large squares make the last part. A part that is as it was keeps its key.
void TeQuadtreeMesh::drawTogether(bool isAnew) {
  const std::uint32_t large = std::uint32_t(m_ranges.size()) - 1;
  m_ranges[large] = {std::uint32_t(m_drawn.size()), std::uint32_t(m_large.size()), 0};
  std::int64_t others = 0;
  for (const Part& part : m_parts)
    others += part.triangles;
  m_parts.push_back({large, m_result.triangles - others, 0});
  m_drawn.insert(m_drawn.end(), m_large.begin(), m_large.end());

  m_result.changed = false;
  for (Part& part : m_parts) {
    Range& range = m_ranges[part.place];
    const Range& last = m_lastRanges[part.place];
    const auto first = m_drawn.begin() + std::ptrdiff_t(range.first);
    const bool isSame = !isAnew && last.key != 0 && range.count == last.count &&
                        std::equal(first, first + std::ptrdiff_t(range.count),
                                   m_lastDrawn.begin() + std::ptrdiff_t(last.first));
    range.key = isSame ? last.key : ++m_lastKey;
    part.key = range.key;
    m_result.changed = m_result.changed || !isSame;
  }
  for (std::size_t place = 0; place < m_ranges.size(); place++)
    m_result.changed = m_result.changed || (m_ranges[place].key != m_lastRanges[place].key);
}

/// With the document's tests: what the triangles of a square are worth.
void TeQuadtreeMesh::boundDrawn(std::uint32_t number, std::uint32_t enabled) {
  const Square& square = m_squares[number];
  const auto look = [&](double error, const TeQuadtreeBox& box) {
    const double pixels2 = m_metric.pixels2(error, m_metric.distance2(box));
    if (pixels2 > m_worst2 && inView(square, box))
      m_worst2 = pixels2;
  };
  for (int i = 0; i < 4; i++) {
    if ((enabled >> i & 1) == 0 && m_tree->square(square.data).hasSide(i)) {
      const std::uint32_t neighbour = neighbourData(number, i);
      look(edgeError(square, i, neighbour), boxOfEdge(square, i, neighbour));
    }
    const std::uint32_t child = m_tree->child(square.data, i);
    const bool isThere = ((enabled >> i | enabled >> Sides::next(i)) & 1) != 0; // a triangle to bisect
    if ((enabled >> (4 + i) & 1) == 0 && child != 0 && isThere)
      look(double(teUnpack(m_tree->square(child).centreError)), boxOfChild(square, i, child));
  }
}

/// No vertex has a number yet.
void TeQuadtreeMesh::beginAppend() const {
  m_append++;
  if (m_append == 0) {
    m_numbers.clear();
    m_append = 1;
  }
  m_numbers.resize(m_vertices.size(), Number{0, 0});
}

void TeQuadtreeMesh::append(TeLodMesh& mesh) const {
  mesh.indices.reserve(mesh.indices.size() + 3 * std::size_t(m_result.triangles));
  beginAppend();
  appendRange(0, m_drawn.size(), mesh);
}

void TeQuadtreeMesh::append(const Part& part, TeLodMesh& mesh) const {
  beginAppend();
  appendRange(m_ranges[part.place].first, m_ranges[part.place].count, mesh);
}

void TeQuadtreeMesh::appendRange(std::size_t first, std::size_t count, TeLodMesh& mesh) const {
  const auto numberOf = [&](std::uint32_t vertex) {
    Number& number = m_numbers[vertex];
    if (number.append != m_append) {
      const Vertex& v = m_vertices[vertex];
      number = {m_append, std::uint32_t(mesh.vertices.size())};
      mesh.vertices.push_back({v.column, v.row, m_morphed ? v.drawn : v.height});
    }
    return number.number;
  };
  std::size_t triangles = 0;
  for (std::size_t i = first; i < first + count; i++)
    triangles += trianglesOf(m_drawn[i].shape);
  const std::size_t before = mesh.indices.size();
  mesh.indices.resize(before + 3 * triangles);
  std::uint32_t* next = mesh.indices.data() + before;
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    next[0] = a;
    next[1] = b;
    next[2] = c;
    next += 3;
  };
  for (std::size_t i = first; i < first + count; i++) {
    const Drawn& drawn = m_drawn[i];
    const std::uint32_t children = drawn.shape >> 4 & 15;
    if (children == 15)
      continue;
    const Square& square = m_squares[drawn.square];
    const std::uint32_t centre = numberOf(square.vertices[kCentre]);
    for (int s = 0; s < 4; s++) {
      const bool isSplit = (drawn.shape >> s & 1) != 0;
      const bool isFirstCovered = (children >> Sides::previous(s) & 1) != 0;
      const bool isLastCovered = (children >> s & 1) != 0;
      if (isFirstCovered && isLastCovered)
        continue;
      if (!isSplit) {
        triangle(centre, numberOf(square.corners[Sides::previous(s)]), numberOf(square.corners[s]));
        continue;
      }
      const std::uint32_t middle = numberOf(square.vertices[s]);
      if (!isFirstCovered)
        triangle(centre, numberOf(square.corners[Sides::previous(s)]), middle);
      if (!isLastCovered)
        triangle(centre, middle, numberOf(square.corners[s]));
    }
  }
  assert(next == mesh.indices.data() + mesh.indices.size());
}
