#include "nodes/lod/TeLatticeTriangle.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

namespace {

using Sample = std::pair<int, int>;

int area(const TeLodVertex& a, const TeLodVertex& b, int column, int row) {
  return (b.column - a.column) * (row - a.row) - (column - a.column) * (b.row - a.row);
}

} // namespace

// Closed: every sample inside or on the rim, and no other.
TEST(TeLatticeTriangle, SpansAreTheSamplesThatATriangleCovers) {
  std::mt19937 random(1);
  const auto any = [&] { return TeLodVertex{int(random() % 17), int(random() % 17), 0}; };
  int triangles = 0;
  while (triangles < 2000) {
    const TeLodVertex a = any(), b = any(), c = any();
    const int whole = area(a, b, c.column, c.row);
    if (whole == 0)
      continue;
    triangles++;
    std::map<Sample, int> covered;
    const TeLatticeTriangle triangle(a, b, c);
    for (int row = triangle.firstRow(); row <= triangle.lastRow(); row++)
      for (int column = triangle.span(row).first; column <= triangle.span(row).last; column++)
        covered[{column, row}]++;
    for (int row = 0; row < 17; row++)
      for (int column = 0; column < 17; column++) {
        const int sign = whole > 0 ? 1 : -1;
        const bool inside = area(a, b, column, row) * sign >= 0 && area(b, c, column, row) * sign >= 0 &&
                            area(c, a, column, row) * sign >= 0;
        ASSERT_EQ(covered.count({column, row}) == 1, inside);
      }
  }
}

// So triangles that share edges count no sample twice.
TEST(TeLatticeTriangle, OpenSpansOfAFanCountEverySampleOnce) {
  const int side = 16;
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; trial++) {
    const TeLodVertex corners[] = {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}};
    const TeLodVertex middle{1 + int(random() % 15), 1 + int(random() % 15), 0};
    std::map<Sample, int> counted;
    for (int i = 0; i < 4; i++) {
      const TeLatticeTriangle triangle(corners[i], corners[(i + 1) % 4], middle);
      for (int row = triangle.firstRow(); row <= triangle.lastRow(); row++)
        for (int column = triangle.span(row).first; column < triangle.span(row).openEnd; column++)
          counted[{column, row}]++;
    }
    for (int row = 0; row < side; row++)
      for (int column = 0; column < side; column++)
        ASSERT_EQ((counted[{column, row}]), 1) << column << " " << row;
  }
}
