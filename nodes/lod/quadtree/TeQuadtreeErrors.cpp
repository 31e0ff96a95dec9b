#include "nodes/lod/quadtree/TeQuadtree.h"

#include <algorithm>
#include <cmath>

using Sides = TeQuadtreeSides;

namespace {

/// A corner of a triangle: its height, and that of the plane that it is compared with.
struct Corner {
  double height;
  double plane;
  double deviation() const { return std::fabs(height - plane); }
};

Corner between(float height, const Corner& a, const Corner& b) {
  return {double(height), (a.plane + b.plane) / 2};
}

/// For rounding in the planes.
constexpr double kMargin = 1 + 1e-12;

} // namespace

/// Deviations of triangles over all vertices, exact but for being rounded up. Bottom-up: parts of a triangle
/// that cannot hold its largest deviation, by their own errors, are passed over.
struct TeQuadtree::Errors {
  TeQuadtree& tree;
  bool all;

  const TeQuadtreeSquare& at(std::uint32_t number) const { return tree.m_squares[number]; }

  /// Of the triangle between the centre of a square and a side, `a` to `b`: raises `worst`.
  void overSide(std::uint32_t number, int s, const Corner& a, const Corner& b, const Corner& centre,
                double& worst) const {
    const TeQuadtreeSquare& square = at(number);
    if (!square.hasSide(s))
      return; // then it has no children either
    const Corner middle = between(square.edge[s], a, b);
    worst = std::max(worst, middle.deviation());
    if (square.block() == 0)
      return;
    overQuadrant(number, Sides::previous(s), s, a, middle, centre, worst);
    overQuadrant(number, s, s, b, middle, centre, worst);
  }

  /// Of the half of a quadrant at a side: between its corner, the middle of the side and the centre.
  void overQuadrant(std::uint32_t number, int k, int s, const Corner& corner, const Corner& middle,
                    const Corner& centre, double& worst) const {
    const std::uint32_t child = tree.child(number, k);
    if (child == 0)
      return;
    const double most = std::max({corner.deviation(), middle.deviation(), centre.deviation()}) +
                        double(teUnpack(at(child).centreError));
    if (most * kMargin < worst)
      return;
    const Corner inner = between(at(child).centre, corner, centre);
    worst = std::max(worst, inner.deviation());
    if (s == k) { // the side runs from `middle` to `corner`
      overSide(child, s, middle, corner, inner, worst);
      overSide(child, Sides::previous(k), centre, middle, inner, worst);
    } else {
      overSide(child, s, corner, middle, inner, worst);
      overSide(child, Sides::opposite(k), middle, centre, inner, worst);
    }
  }

  static Corner vertex(float height) { return {double(height), double(height)}; }

  double ofSide(const TeQuadtreePlace& place, std::uint32_t number, int s, int sideSeen) const {
    double worst = 0;
    const Corner a = vertex(place.corners[Sides::previous(s)]), b = vertex(place.corners[s]);
    const Corner centre = vertex(at(number).centre);
    if (sideSeen == s)
      overSide(number, sideSeen, a, b, centre, worst);
    else
      overSide(number, sideSeen, b, a, centre, worst);
    return worst;
  }

  double ofChild(const TeQuadtreePlace& place, int k) const {
    const TeQuadtreeSquare& square = at(place.square);
    double worst = 0;
    for (const int s : {k, Sides::next(k)})
      overQuadrant(place.square, k, s, vertex(place.corners[k]), vertex(square.edge[s]),
                   vertex(square.centre), worst);
    return worst;
  }

  bool skips(const TeQuadtreePlace& place) const {
    return !all && !at(place.square).has(TeQuadtreeSquare::kDirty);
  }

  /// Ranges, the errors of children's centres and the document's errors: from what lies inside alone.
  void inside(const TeQuadtreePlace& place) {
    if (skips(place))
      return;
    const bool divided = at(place.square).block() != 0;
    for (int k = 0; divided && k < 4; k++)
      inside(place.child(tree.m_squares, k));

    TeQuadtreeSquare& square = tree.m_squares[place.square];
    double low = double(square.centre), high = low, largest = 0;
    for (int s = 0; s < 4; s++) {
      for (const float height : {place.corners[s], square.edge[s]}) {
        low = std::min(low, double(height));
        high = std::max(high, double(height));
      }
      if (square.hasSide(s))
        largest = std::max(largest,
                           fromMiddle(square.edge[s], place.corners[Sides::previous(s)], place.corners[s]));
    }
    for (int k = 0; divided && k < 4; k++) {
      TeQuadtreeSquare& child = tree.m_squares[tree.child(place.square, k)];
      child.centreError = 0xFF00; // or it would bound itself
      low = std::min(low, child.low());
      high = std::max(high, child.high());
      largest = std::max({largest, double(teUnpack(child.largestError)),
                          fromMiddle(child.centre, square.centre, place.corners[k])});
    }
    for (int k = 0; divided && k < 4; k++) {
      const std::uint32_t child = tree.child(place.square, k);
      tree.m_squares[child].centreError = tePackUp(ofChild(place, k));
    }
    square.below = tePackUp(double(square.centre) - low);
    square.above = tePackUp(high - double(square.centre));
    square.largestError = tePackUp(largest);
  }

  static double fromMiddle(float height, float a, float b) {
    return std::fabs(double(height) - (double(a) + double(b)) / 2);
  }

  /// Errors of the middles of edges, which are inside of two squares.
  void edges(const TeQuadtreePlace& place) {
    if (skips(place))
      return;
    TeQuadtreeSquare& square = tree.m_squares[place.square];
    square.set(TeQuadtreeSquare::kDirty, false);
    square.eastError = tePackUp(ofEdge(place, Sides::kEast));
    square.southError = tePackUp(ofEdge(place, Sides::kSouth));
    if (tree.isRim(place, Sides::kNorth))
      tree.m_rim[0][std::size_t(place.x + place.half())] = tePackUp(ofEdge(place, Sides::kNorth));
    if (tree.isRim(place, Sides::kWest))
      tree.m_rim[1][std::size_t(place.y + place.half())] = tePackUp(ofEdge(place, Sides::kWest));
    for (int k = 0; square.block() != 0 && k < 4; k++)
      edges(place.child(tree.m_squares, k));
  }

  double ofEdge(const TeQuadtreePlace& place, int s) const {
    if (!at(place.square).hasSide(s))
      return 0;
    const double own = ofSide(place, place.square, s, s);
    const std::uint32_t neighbour = place.neighbours[s];
    return neighbour == 0 ? own : std::max(own, ofSide(place, neighbour, s, Sides::opposite(s)));
  }
};

void TeQuadtree::refreshErrors() {
  Errors errors{*this, m_refreshesAll};
  m_refreshesAll = false;
  errors.inside(root());
  errors.edges(root());
}
