#include "nodes/lod/TeTriangleDeviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace {

constexpr int kSide = 65;

template <class Height> TeHeightMap mapOf(Height height) {
  TeHeightMap map = std::move(TeHeightMap::create(kSide, kSide).value());
  for (int row = 0; row < kSide; row++)
    for (int column = 0; column < kSide; column++)
      map.at(column, row) = float(height(column, row));
  return map;
}

/// Over all samples whose three areas have the triangle's sign.
double deviationByAreas(const TeHeightMap& map, const TeLodVertex& a, const TeLodVertex& b,
                        const TeLodVertex& c) {
  const auto area = [](const TeLodVertex& p, const TeLodVertex& q, int column, int row) {
    return (q.column - p.column) * (row - p.row) - (column - p.column) * (q.row - p.row);
  };
  const int whole = area(a, b, c.column, c.row), sign = whole > 0 ? 1 : -1;
  double worst = 0;
  for (int row = 0; row < kSide; row++)
    for (int column = 0; column < kSide; column++) {
      const int ab = area(a, b, column, row), bc = area(b, c, column, row), ca = area(c, a, column, row);
      if (ab * sign < 0 || bc * sign < 0 || ca * sign < 0)
        continue;
      const double plane = (double(a.height) * bc + double(b.height) * ca + double(c.height) * ab) / whole;
      worst = std::max(worst, std::fabs(double(map.at(column, row)) - plane));
    }
  return worst;
}

TeLodVertex vertexOf(const TeHeightMap& map, int column, int row) {
  return {column, row, map.at(column, row)};
}

} // namespace

TEST(TeTriangleDeviation, IsThatOfTheWorstSampleRoundedUp) {
  std::mt19937 random(3);
  const TeHeightMap map = mapOf([&](int, int) { return double(random() % 100000) / 7 - 5000; });
  int tried = 0;
  while (tried < 4000) {
    // Slivers, narrow and wide ones, of both orientations.
    const int reach = tried % 3 == 0 ? kSide : tried % 3 == 1 ? 5 : 14;
    TeLodVertex corners[3];
    for (TeLodVertex& corner : corners)
      corner = vertexOf(map, int(random() % std::uint32_t(reach)), int(random() % std::uint32_t(reach)));
    const auto& [a, b, c] = corners;
    if ((b.column - a.column) * (c.row - a.row) == (c.column - a.column) * (b.row - a.row))
      continue;
    tried++;
    const double wanted = deviationByAreas(map, a, b, c);
    const double found = teTriangleDeviation(map, a, b, c);
    EXPECT_GE(found, wanted * (1 - 1e-13));
    EXPECT_LE(found, std::nextafter(float(wanted), std::numeric_limits<float>::infinity()));
  }
}

TEST(TeTriangleDeviation, IsNothingOnPlanes) {
  const TeHeightMap map = mapOf([](int column, int row) { return 40 - 3 * column + 2 * row; });
  for (const int size : {1, 2, 13, 64}) {
    const auto at = [&](int column, int row) { return vertexOf(map, column, row); };
    EXPECT_EQ(teTriangleDeviation(map, at(0, 0), at(size, 0), at(size, size)), 0);
    EXPECT_EQ(teTriangleDeviation(map, at(size, 0), at(size / 2, size), at(0, size)), 0);
  }
}

TEST(TeTriangleDeviation, SeesSamplesOnTheRimAndNoneBeside) {
  const TeLodVertex a{8, 8, 0}, b{40, 8, 0}, c{24, 24, 0};
  const auto spikeAt = [](int x, int y) {
    return mapOf([=](int column, int row) { return column == x && row == y ? 5 : 0; });
  };
  for (const auto& [x, y] : {std::pair(9, 8), std::pair(39, 8), std::pair(24, 8), std::pair(9, 9),
                             std::pair(23, 23), std::pair(25, 23), std::pair(39, 9), std::pair(24, 16)})
    EXPECT_EQ(teTriangleDeviation(spikeAt(x, y), a, b, c), 5) << x << " " << y;
  for (const auto& [x, y] : {std::pair(7, 8), std::pair(41, 8), std::pair(24, 7), std::pair(9, 10),
                             std::pair(22, 23), std::pair(26, 23), std::pair(24, 25)})
    EXPECT_EQ(teTriangleDeviation(spikeAt(x, y), a, b, c), 0) << x << " " << y;
}
