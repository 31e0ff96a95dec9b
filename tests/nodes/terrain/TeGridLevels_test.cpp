#include "nodes/terrain/TeGridLevels.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace {

/// Rim edges as pairs of indices.
std::set<std::pair<std::uint32_t, std::uint32_t>> rimOf(int columns, int rows) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
  const auto add = [&](int a, int b) {
    rim.insert(std::minmax<std::uint32_t>(std::uint32_t(a), std::uint32_t(b)));
  };
  for (int x = 0; x + 1 < columns; ++x) {
    add(x, x + 1);
    add((rows - 1) * columns + x, (rows - 1) * columns + x + 1);
  }
  for (int y = 0; y + 1 < rows; ++y) {
    add(y * columns, (y + 1) * columns);
    add(y * columns + columns - 1, (y + 1) * columns + columns - 1);
  }
  return rim;
}

void checkLevel(const TeGridLevels& levels, int level) {
  const int columns = levels.columns(), rows = levels.rows();
  std::set<std::pair<std::uint32_t, std::uint32_t>> once; // directed edges
  std::int64_t doubleArea = 0;
  const std::vector<std::uint32_t>& indices = levels.indices(level);
  ASSERT_EQ(indices.size() % 3, 0u);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::int64_t x[3], y[3];
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(indices[i + k], std::uint32_t(columns * rows));
      x[k] = indices[i + k] % std::uint32_t(columns);
      y[k] = indices[i + k] / std::uint32_t(columns);
      // Each edge has one triangle on either side.
      EXPECT_TRUE(once.insert({indices[i + k], indices[i + (k + 1) % 3]}).second);
    }
    const std::int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    EXPECT_GT(area, 0);
    doubleArea += area;
  }
  EXPECT_EQ(doubleArea, 2 * std::int64_t(columns - 1) * (rows - 1));
  std::set<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const auto& [from, to] : once)
    if (!once.count({to, from}))
      open.insert(std::minmax(from, to));
  EXPECT_EQ(open, rimOf(columns, rows));
}

} // namespace

// Every triangle counter-clockwise and not flat, every inner edge with one triangle on either side, the area
// that of the grid, and the rim's edges all there: so whatever fits one level fits all.
TEST(TeGridLevels, EachLevelCoversTheGridOnceAndKeepsTheRim) {
  int levelsSeen = 0;
  for (int columns = 1; columns <= 36; ++columns)
    for (int rows = 1; rows <= 36; rows += columns % 9 == 4 ? 1 : 5) {
      SCOPED_TRACE(testing::Message() << columns << " x " << rows);
      const TeGridLevels levels(columns, rows);
      for (int level = 1; level <= levels.count(); ++level, ++levelsSeen)
        checkLevel(levels, level);
    }
  EXPECT_GT(levelsSeen, 300);
  for (const int side : {63, 65, 127, 255}) {
    const TeGridLevels levels(side, side);
    for (int level = 1; level <= levels.count(); ++level)
      checkLevel(levels, level);
  }
}

TEST(TeGridLevels, EachLevelHasFewerTriangles) {
  const TeGridLevels levels(31, 31);
  ASSERT_EQ(levels.count(), 4);
  EXPECT_EQ(levels.triangles(1), 568);
  EXPECT_EQ(levels.triangles(2), 216);
  EXPECT_EQ(levels.triangles(3), 136);
  EXPECT_EQ(levels.triangles(4), 120);
  for (int side = 4; side < 100; ++side) {
    const TeGridLevels grid(side, side);
    ASSERT_GE(grid.count(), 1);
    std::int64_t before = 2 * std::int64_t(side - 1) * (side - 1);
    for (int level = 1; level <= grid.count(); ++level) {
      EXPECT_LT(grid.triangles(level), before) << side << " " << level;
      before = grid.triangles(level);
    }
  }
}

TEST(TeGridLevels, StripsLoseTheirMiddleLine) {
  for (const auto& [columns, rows] : {std::pair(3, 31), std::pair(31, 3)}) {
    const TeGridLevels levels(columns, rows);
    ASSERT_EQ(levels.count(), 1);
    EXPECT_EQ(levels.triangles(1), 62);
  }
}

TEST(TeGridLevels, SmallGridsHaveNone) {
  EXPECT_EQ(TeGridLevels(3, 3).count(), 0);
  EXPECT_EQ(TeGridLevels(2, 31).count(), 0);
  EXPECT_EQ(TeGridLevels(0, 0).count(), 0);
}
