#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

#include <algorithm>
#include <cmath>

using Sides = TeQuadtreeSides;

/// Of a vertex that bisects triangles with this error: 0 where it has just been enabled for it.
float TeQuadtreeMesh::ownWeight(double error, const TeQuadtreeBox& box) const {
  const double ratio = std::sqrt(m_metric.pixels2(error, m_metric.distance2(box)) / m_wanted2);
  return ratio > 1 ? float(std::min((ratio - 1) / kMorphBand, 1.0)) : 0.0f; // NaN: nothing is wanted
}

/// No vertex is ahead of those that it depends on: one that has just been enabled takes all that came with it
/// along, so that they begin on the surface as it was.
float TeQuadtreeMesh::centreWeight(std::uint32_t number) {
  const Square& square = m_squares[number];
  Vertex& vertex = m_vertices[square.vertices[kCentre]];
  if (number == 0)
    return 1;
  if (vertex.mark != m_frame) {
    vertex.mark = m_frame;
    vertex.weight =
        ownWeight(double(teUnpack(m_tree->square(square.data).centreError)), boxOf(square, square.data));
    if (vertex.weight > 0)
      vertex.weight *= std::min(edgeWeight(square.parent, square.quadrant),
                                edgeWeight(square.parent, Sides::next(square.quadrant)));
  }
  return vertex.weight;
}

float TeQuadtreeMesh::edgeWeight(std::uint32_t number, int s) {
  const Square& square = m_squares[number];
  Vertex& vertex = m_vertices[square.vertices[s]];
  if (vertex.mark != m_frame) {
    vertex.mark = m_frame;
    const std::uint32_t neighbour = neighbourData(number, s);
    vertex.weight = ownWeight(edgeError(square, s, neighbour), boxOfEdge(square, s, neighbour));
    if (vertex.weight > 0)
      vertex.weight *= std::min(centreWeight(number),
                                square.neighbours[s] != 0 ? centreWeight(square.neighbours[s]) : 1.0f);
  }
  return vertex.weight;
}

/// Its centre and the middles of its edges; corners are those of larger squares, which were before it.
void TeQuadtreeMesh::morphSquare(std::uint32_t number) {
  const Square& square = m_squares[number];
  const auto drawn = [&](int corner) { return m_vertices[square.corners[corner]].drawn; };
  if (number != 0) {
    centreWeight(number);
    morphVertex(m_vertices[square.vertices[kCentre]], drawn(square.quadrant),
                drawn(Sides::opposite(square.quadrant)), boxOf(square, square.data));
  }
  for (int s = 0; s < 4; s++) {
    if ((square.edges >> s & 1) == 0)
      continue;
    edgeWeight(number, s);
    morphVertex(m_vertices[square.vertices[s]], drawn(Sides::previous(s)), drawn(s),
                boxOfEdge(square, s, neighbourData(number, s)));
  }
}

/// `box` holds all triangles at the vertex, so that what it is off by counts at that distance.
void TeQuadtreeMesh::morphVertex(Vertex& vertex, float a, float b, const TeQuadtreeBox& box) {
  const double distance2 = m_metric.distance2(box), height = double(vertex.height);
  const double middle = (double(a) + double(b)) / 2;
  const double allowed = morphPixels();
  const double pixels = m_metric.focal() > 0 ? m_metric.focal() : 1;
  const double most = allowed * std::sqrt(distance2) / pixels;
  vertex.drawn = float(height + std::clamp((1 - double(vertex.weight)) * (middle - height), -most, most));
  if (std::fabs(double(vertex.drawn) - height) > most)
    vertex.drawn = std::nextafter(vertex.drawn, vertex.height); // it was rounded
  const double offset = double(vertex.drawn) - height;
  m_worstOffset = std::max(m_worstOffset, std::sqrt(m_metric.pixels2(offset, distance2)));
}
