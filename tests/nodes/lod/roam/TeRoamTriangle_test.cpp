#include "nodes/lod/roam/TeRoamTriangle.h"

#include "nodes/lod/TeWatertight.h"
#include "nodes/lod/roam/TeRoamFan.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace {

constexpr int kLog = 4;

std::uint32_t place(const TeRoamTriangle::Point& point) {
  return std::uint32_t(point.row * ((1 << kLog) + 1) + point.column);
}

void forEach(int level, const std::function<void(const TeRoamTriangle&)>& visit) {
  for (int y = 0; y < 1 << level; y++)
    for (int x = 0; x < 1 << level; x++)
      for (const bool upper : {false, true})
        visit({level, x, y, upper});
}

bool isSame(const TeRoamTriangle& a, const TeRoamTriangle& b) {
  return a.level == b.level && a.x == b.x && a.y == b.y && a.upper == b.upper;
}

} // namespace

TEST(TeRoamTriangle, eachLevelTilesTheSquare) {
  for (int level = 0; level <= kLog; level++) {
    TeWatertight mesh(1 << kLog);
    forEach(level, [&](const TeRoamTriangle& triangle) {
      mesh.add(place(triangle.corner(0, kLog)), place(triangle.corner(1, kLog)),
               place(triangle.corner(2, kLog)));
    });
    EXPECT_TRUE(mesh.coversSquare());
    EXPECT_EQ(mesh.slivers(), 0);
    EXPECT_EQ(mesh.cracks(), 0);
  }
}

TEST(TeRoamTriangle, childrenLieBetweenCornersAndMiddles) {
  for (int level = 0; level < kLog; level++)
    forEach(level, [&](const TeRoamTriangle& triangle) {
      const std::uint32_t c[3] = {place(triangle.corner(0, kLog)), place(triangle.corner(1, kLog)),
                                  place(triangle.corner(2, kLog))};
      const std::uint32_t m[3] = {place(triangle.middle(0, kLog)), place(triangle.middle(1, kLog)),
                                  place(triangle.middle(2, kLog))};
      const std::uint32_t wanted[4][3] = {
          {c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[1], m[2], m[0]}};
      for (int k = 0; k < 4; k++)
        for (int corner = 0; corner < 3; corner++)
          EXPECT_EQ(place(triangle.child(k).corner(corner, kLog)), wanted[k][corner]);
    });
}

TEST(TeRoamTriangle, parentsAndNumbersFollowFromThePlaceAlone) {
  std::set<std::uint32_t> numbers;
  for (int level = 0; level <= kLog; level++)
    forEach(level, [&](const TeRoamTriangle& triangle) {
      EXPECT_TRUE(numbers.insert(triangle.number()).second);
      EXPECT_GE(triangle.number(), TeRoamTriangle::firstNumber(level));
      EXPECT_LT(triangle.number(), TeRoamTriangle::firstNumber(level + 1));
      for (int k = 0; k < 4; k++) {
        const TeRoamTriangle child = triangle.child(k);
        EXPECT_EQ(child.childNumber(), k);
        EXPECT_TRUE(isSame(child.parent(), triangle));
        EXPECT_EQ(child.number(), TeRoamTriangle::childOf(triangle.number(), k));
        EXPECT_EQ(TeRoamTriangle::parentOf(child.number()), triangle.number());
      }
    });
  EXPECT_EQ(numbers.size(), TeRoamTriangle::firstNumber(kLog + 1));
}

// The deepest triangle of the largest terrain.
TEST(TeRoamTriangle, numbersFitTheLargestTerrain) {
  const TeRoamTriangle last{14, (1 << 14) - 1, (1 << 14) - 1, true};
  TeRoamTriangle triangle = last;
  std::uint32_t number = last.number();
  for (; triangle.level > 0; triangle = triangle.parent())
    number = TeRoamTriangle::parentOf(number);
  EXPECT_EQ(number, triangle.number());
  EXPECT_TRUE(triangle.upper);
}

TEST(TeRoamFan, coversTheTriangleAndUsesEveryEdgePoint) {
  const int x[] = {0, 2, 2, 1, 2, 1}, y[] = {0, 0, 2, 0, 1, 1};
  for (int mask = 0; mask < 8; mask++) {
    const TeRoamFan& fan = TeRoamFan::all()[std::size_t(mask)];
    int area = 0, used = 0;
    std::multiset<std::pair<int, int>> edges;
    for (int i = 0; i < fan.count; i++) {
      const TeRoamFan::Triangle& t = fan.triangles[std::size_t(i)];
      const int twice = (x[t[1]] - x[t[0]]) * (y[t[2]] - y[t[0]]) - (x[t[2]] - x[t[0]]) * (y[t[1]] - y[t[0]]);
      EXPECT_GT(twice, 0);
      area += twice;
      for (std::size_t k = 0; k < 3; k++) {
        used |= 1 << t[k];
        edges.insert(std::minmax<int>(t[k], t[(k + 1) % 3]));
      }
    }
    EXPECT_EQ(area, 4);
    EXPECT_EQ(used, 7 | mask << 3);
    // Along the rim from corner to corner over edge points, each once; inside, each edge twice.
    for (int k = 0; k < 3; k++) {
      const bool isPoint = mask >> k & 1;
      EXPECT_EQ(edges.erase(std::minmax(k, (k + 1) % 3)), isPoint ? 0u : 1u);
      EXPECT_EQ(edges.erase(std::minmax(k, 3 + k)), isPoint ? 1u : 0u);
      EXPECT_EQ(edges.erase(std::minmax((k + 1) % 3, 3 + k)), isPoint ? 1u : 0u);
    }
    for (const auto& edge : edges)
      EXPECT_EQ(edges.count(edge), 2u);
  }
}
