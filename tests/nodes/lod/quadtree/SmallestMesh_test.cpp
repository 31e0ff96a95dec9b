#include "nodes/lod/quadtree/TeQuadtreeMesh.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace {

constexpr int kCells = 32;

using Place = std::pair<int, int>; ///< column, row

/// The rules once more, over vertices alone: a right triangle is bisected in the middle of its hypotenuse.
class Reference {
public:
  Reference(const TeQuadtree& tree, const TeLodView& view, double wanted)
      : m_tree(tree), m_view(view), m_wanted(wanted) {}

  /// Adds what is needed until nothing is.
  std::set<Place> vertices() {
    m_enabled = {{0, 0}, {kCells, 0}, {0, kCells}, {kCells, kCells}, {kCells / 2, kCells / 2}};
    for (std::size_t before = 0; before != m_enabled.size();) {
      before = m_enabled.size();
      const Place centre{kCells / 2, kCells / 2};
      const Place corners[4] = {{kCells, 0}, {kCells, kCells}, {0, kCells}, {0, 0}};
      for (int s = 0; s < 4; s++)
        triangle(corners[s], corners[(s + 1) % 4], centre);
    }
    return m_enabled;
  }

private:
  static Place middle(const Place& a, const Place& b) {
    return {(a.first + b.first) / 2, (a.second + b.second) / 2};
  }

  /// Of a hypotenuse a b; displayed unless it is bisected.
  void triangle(const Place& a, const Place& b, const Place& apex) {
    if (std::max(std::abs(a.first - b.first), std::abs(a.second - b.second)) < 2)
      return; // no vertex is between them
    const Place vertex = middle(a, b);
    if (m_enabled.count(vertex) == 0 && isNeeded(vertex, apex))
      m_enabled.insert(vertex);
    if (m_enabled.count(vertex) == 0)
      return;
    // The apex on the other side, too: it is this one, mirrored.
    const Place other{2 * vertex.first - apex.first, 2 * vertex.second - apex.second};
    if (other.first >= 0 && other.second >= 0 && other.first <= kCells && other.second <= kCells)
      m_enabled.insert(other);
    triangle(apex, a, vertex);
    triangle(b, apex, vertex);
  }

  /// Error and box of both triangles, as the squares have them.
  bool isNeeded(const Place& vertex, const Place& apex) const {
    const int reach = std::max(std::abs(vertex.first - apex.first), std::abs(vertex.second - apex.second));
    double error = 0, low = 1e30, high = -1e30;
    glm::dvec2 west(vertex.first - reach, vertex.second - reach),
        east(vertex.first + reach, vertex.second + reach);
    const auto include = [&](const TeQuadtreeSquare& square) {
      low = std::min(low, square.low());
      high = std::max(high, square.high());
    };
    int log = 0;
    while (1 << log < reach)
      log++;
    if (vertex.first != apex.first &&
        vertex.second != apex.second) { // the centre of a square of side 2·reach
      const TeQuadtreeSquare& square =
          m_tree.square(m_tree.find(log + 1, vertex.first - reach, vertex.second - reach)->square);
      error = double(teUnpack(square.centreError));
      include(square);
    } else {
      const int dx = apex.second == vertex.second ? reach : 0, dy = reach - dx;
      // Squares to the south or west of the edge, and to the north or east.
      const auto first = m_tree.find(log + 1, vertex.first - reach - dx, vertex.second - reach - dy);
      const auto second = m_tree.find(log + 1, vertex.first - reach + dx, vertex.second - reach + dy);
      if (first)
        include(m_tree.square(first->square));
      if (second)
        include(m_tree.square(second->square));
      if (dx > 0)
        error = first ? double(teUnpack(m_tree.square(first->square).eastError))
                      : m_tree.rimError(TeQuadtreeSides::kWest, vertex.second);
      else
        error = second ? double(teUnpack(m_tree.square(second->square).southError))
                       : m_tree.rimError(TeQuadtreeSides::kNorth, vertex.first);
      west = glm::max(west, glm::dvec2(0));
      east = glm::min(east, glm::dvec2(kCells));
    }
    const glm::dvec3 nearest = glm::clamp(m_view.eye, glm::dvec3(west, low), glm::dvec3(east, high));
    return m_view.meets(glm::dvec3(west, low), glm::dvec3(east, high)) &&
           m_view.pixels(error, glm::distance(nearest, m_view.eye)) > m_wanted;
  }

  const TeQuadtree& m_tree;
  const TeLodView m_view;
  double m_wanted;
  std::set<Place> m_enabled;
};

} // namespace

// Nothing is displayed that neither the view nor the rules need, after any history.
TEST(TeQuadtreeMesh, IsTheSmallestThatKeepsTheRules) {
  std::mt19937 random(9);
  std::int64_t triangles = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    const TeQuadtree tree = TeQuadtree::create(stressMap(StressField(kind), kCells, random)).value();
    TeQuadtreeMesh mesh(tree, {});
    for (int trial = 0; trial < 30; trial++) {
      TeLodView view = viewFrom(anyEye(random, kCells, 0.5 * kCells), 300);
      TeQuadtreeMesh::Wish wish;
      wish.pixelError = std::exp(std::uniform_real_distribution<double>(0, 6)(random));
      mesh.update(view, wish);
      TeLodMesh drawn;
      mesh.append(drawn);
      std::set<Place> vertices;
      for (const TeLodVertex& vertex : drawn.vertices)
        vertices.insert({vertex.column, vertex.row});
      ASSERT_TRUE(Reference(tree, view, wish.pixelError).vertices() == vertices)
          << "field " << kind << ", trial " << trial;
      triangles += drawn.triangles();
    }
  }
  EXPECT_GT(triangles, 5000);
}
