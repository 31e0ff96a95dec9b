#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <algorithm>
#include <cassert>

using Sides = TeQuadtreeSides;

namespace {

/// A side is one triangle, or two of which children cover some. Bits as in Drawn::shape.
std::uint32_t trianglesOf(std::uint32_t shape) {
  return std::uint32_t(4 + __builtin_popcount(shape & 15) - 2 * __builtin_popcount(shape >> 4 & 15));
}

} // namespace

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
