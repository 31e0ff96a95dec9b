#include "nodes/lod/rtin/TeRtinTriangle.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using Corner = TeRtinTriangle::Corner;
using Pair = std::pair<int, int>;

Pair pairOf(const Corner& corner) { return {corner.column, corner.row}; }

std::int64_t doubleArea(const TeRtinTriangle& t) {
  return std::int64_t(t.b().column - t.a().column) * (t.apex().row - t.a().row) -
         std::int64_t(t.apex().column - t.a().column) * (t.b().row - t.a().row);
}

void walk(const TeRtinTriangle& triangle, std::vector<TeRtinTriangle>& all) {
  all.push_back(triangle);
  if (triangle.isSmallest())
    return;
  walk(triangle.firstHalf(), all);
  walk(triangle.secondHalf(), all);
}

std::vector<TeRtinTriangle> allOf(int log) {
  std::vector<TeRtinTriangle> all;
  for (const int half : {0, 1})
    walk(TeRtinTriangle::root(log, half), all);
  return all;
}

} // namespace

TEST(TeRtinTriangle, HalvesAreHalvesCounterClockwise) {
  for (const TeRtinTriangle& triangle : allOf(4)) {
    EXPECT_GT(doubleArea(triangle), 0);
    EXPECT_EQ((triangle.a().column - triangle.apex().column) *
                      (triangle.b().column - triangle.apex().column) +
                  (triangle.a().row - triangle.apex().row) * (triangle.b().row - triangle.apex().row),
              0); // a right angle
    const int size = 1 << triangle.sizeLog();
    EXPECT_EQ(doubleArea(triangle), triangle.isHalfSquare() ? size * size : size * size / 2);
    if (triangle.isHalfSquare()) {
      EXPECT_EQ(triangle.lowColumn() % size, 0);
      EXPECT_EQ(triangle.lowRow() % size, 0);
      const bool risesEast =
          (triangle.b().column - triangle.a().column > 0) == (triangle.b().row - triangle.a().row > 0);
      EXPECT_EQ(risesEast, (triangle.lowColumn() / size + triangle.lowRow() / size) % 2 == 0);
    }
    if (triangle.isSmallest()) {
      EXPECT_EQ(doubleArea(triangle), 1);
      continue;
    }
    EXPECT_EQ(doubleArea(triangle.firstHalf()), doubleArea(triangle) / 2);
    EXPECT_EQ(doubleArea(triangle.secondHalf()), doubleArea(triangle) / 2);
  }
}

// A vertex halves the triangles around its edge; these exist once their apexes do.
TEST(TeRtinTriangle, NeedsTheApexesOfTheTrianglesItHalves) {
  const int log = 5, cells = 1 << log;
  std::map<Pair, std::set<Pair>> apexes;
  for (const TeRtinTriangle& triangle : allOf(log))
    if (!triangle.isSmallest())
      apexes[pairOf(triangle.middle())].insert(pairOf(triangle.apex()));
  EXPECT_EQ(apexes.size(), std::size_t((cells + 1) * (cells + 1) - 4)); // every sample but the corners
  for (const auto& [vertex, wanted] : apexes) {
    const TeRtinTriangle::Needed needed = TeRtinTriangle::neededFor({vertex.first, vertex.second}, cells);
    EXPECT_EQ((std::set<Pair>{pairOf(needed.first), pairOf(needed.second)}), wanted)
        << vertex.first << " " << vertex.second;
  }
}
