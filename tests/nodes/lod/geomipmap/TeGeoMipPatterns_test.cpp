#include "nodes/lod/TeWatertight.h"
#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

/// Numbers of triangles' corners as samples of a square of `cells`, its south-west one at sample (x0, y0).
void addPatch(const TeGeoMipPatterns& patterns, int level, const TeGeoMipSides& sides, int x0, int y0,
              int cells, std::vector<std::uint32_t>& numbers) {
  std::vector<std::uint32_t> indices;
  patterns.append(level, sides, 0, indices);
  EXPECT_EQ(std::int64_t(indices.size() / 3), patterns.triangles(level, sides));
  const std::uint32_t width = std::uint32_t(patterns.cells(level)) + 1;
  for (const std::uint32_t index : indices) {
    const std::uint32_t x = std::uint32_t(x0) + ((index % width) << level);
    const std::uint32_t y = std::uint32_t(y0) + ((index / width) << level);
    numbers.push_back(y * (std::uint32_t(cells) + 1) + x);
  }
}

template <class Use> void forAllSides(const TeGeoMipPatterns& patterns, int level, Use use) {
  const int last = patterns.levels() - 1;
  for (int s = level; s <= last; s++)
    for (int e = level; e <= last; e++)
      for (int n = level; n <= last; n++)
        for (int w = level; w <= last; w++)
          use(TeGeoMipSides{s, e, n, w});
}

} // namespace

TEST(TeGeoMipPatterns, everyPatchCoversItsSquareWithoutCracks) {
  for (const int cells : {2, 4, 16}) {
    const TeGeoMipPatterns patterns(cells);
    EXPECT_EQ(1 << (patterns.levels() - 1), cells);
    for (int level = 0; level < patterns.levels(); level++)
      forAllSides(patterns, level, [&](const TeGeoMipSides& sides) {
        std::vector<std::uint32_t> numbers;
        addPatch(patterns, level, sides, 0, 0, cells, numbers);
        TeWatertight mesh(cells);
        for (std::size_t i = 0; i < numbers.size(); i += 3)
          mesh.add(numbers[i], numbers[i + 1], numbers[i + 2]);
        ASSERT_EQ(mesh.cracks(), 0) << cells << " level " << level;
        ASSERT_EQ(mesh.slivers(), 0);
        ASSERT_TRUE(mesh.coversSquare());
      });
  }
}

TEST(TeGeoMipPatterns, bordersHaveTheVerticesOfTheirLevel) {
  const int cells = 16;
  const TeGeoMipPatterns patterns(cells);
  for (int level = 0; level < patterns.levels(); level++)
    forAllSides(patterns, level, [&](const TeGeoMipSides& sides) {
      std::vector<std::uint32_t> numbers;
      addPatch(patterns, level, sides, 0, 0, cells, numbers);
      const std::set<std::uint32_t> used(numbers.begin(), numbers.end());
      for (int i = 0; i <= cells; i++) {
        const auto isUsed = [&](int x, int y) { return used.count(std::uint32_t(y * (cells + 1) + x)) == 1; };
        const auto wanted = [&](int side) { return i % (1 << sides[std::size_t(side)]) == 0; };
        ASSERT_EQ(isUsed(i, 0), wanted(0));
        ASSERT_EQ(isUsed(cells, i), wanted(1));
        ASSERT_EQ(isUsed(i, cells), wanted(2));
        ASSERT_EQ(isUsed(0, i), wanted(3));
      }
    });
}

TEST(TeGeoMipPatterns, besideItsOwnLevelAPatchIsTheRegularGrid) {
  for (const int cells : {2, 8, 32}) {
    const TeGeoMipPatterns patterns(cells);
    for (int level = 0; level < patterns.levels(); level++) {
      std::vector<std::uint32_t> numbers;
      addPatch(patterns, level, {level, level, level, level}, 0, 0, cells, numbers);
      const auto triangleOf = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        std::array<std::uint32_t, 3> corners{a, b, c};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        return corners;
      };
      std::multiset<std::array<std::uint32_t, 3>> drawn, wanted;
      for (std::size_t i = 0; i < numbers.size(); i += 3)
        drawn.insert(triangleOf(numbers[i], numbers[i + 1], numbers[i + 2]));
      const auto at = [&](const TeGeoMipPatterns::Point& point) {
        return std::uint32_t(point.y * (cells + 1) + point.x);
      };
      for (const auto& triangle : patterns.regular(level))
        wanted.insert(triangleOf(at(triangle[0]), at(triangle[1]), at(triangle[2])));
      EXPECT_EQ(drawn, wanted);
    }
  }
}

// De Boer's trick costs less than the cells it takes the place of.
TEST(TeGeoMipPatterns, coarserNeighboursTakeTrianglesAway) {
  const TeGeoMipPatterns patterns(32);
  for (int level = 0; level + 1 < patterns.levels(); level++)
    for (int border = level + 1; border < patterns.levels(); border++)
      EXPECT_LT(patterns.triangles(level, {level, border, level, level}),
                patterns.triangles(level, {level, border - 1, level, level}));
}
