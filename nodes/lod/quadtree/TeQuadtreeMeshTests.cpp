#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <algorithm>
#include <cmath>

using Sides = TeQuadtreeSides;

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
