#include "nodes/clipmap/TePyramidTiles.h"

#include "generators/base/TeRandom.h"
#include "nodes/clipmap/testPyramid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

constexpr std::size_t kTileBytes = std::size_t(TePyramidTiles::kTileSide) * TePyramidTiles::kTileSide * 2;

int wrongIn(const TestPyramid& pyramid, TePyramidTiles& tiles, int level, const TeSampleRect& rect) {
  std::vector<unsigned char> samples(std::size_t(rect.count()) * 2);
  const TeStatus status = tiles.read(level, rect, samples.data(), std::size_t(rect.columns) * 2);
  if (!status) {
    ADD_FAILURE() << status.error().message;
    return -1;
  }
  int wrong = 0;
  for (int y = 0; y < rect.rows; y++)
    for (int x = 0; x < rect.columns; x++)
      wrong +=
          !pyramid.isSample(&samples[std::size_t(y * rect.columns + x) * 2], level, rect.x + x, rect.y + y);
  return wrong;
}

} // namespace

TEST(TePyramidTiles, RightWhateverWasReadBeforeAndWithinTheBudget) {
  const TestPyramid pyramid(9);
  for (const std::size_t budget : {std::size_t(0), 3 * kTileBytes, 100 * kTileBytes}) {
    const auto tiles = pyramid.tiles(6, budget);
    ASSERT_TRUE(tiles);
    TeRandom random(budget, 1, {});
    for (int i = 0; i < 200; i++) {
      const int level = 6 + int(random.below(4));
      const auto side = std::uint64_t(tePyramidSide(level));
      TeSampleRect rect;
      rect.x = std::int32_t(random.below(side));
      rect.y = std::int32_t(random.below(side));
      rect.columns =
          1 + std::int32_t(random.below(std::min<std::uint64_t>(40, side - std::uint64_t(rect.x))));
      rect.rows = 1 + std::int32_t(random.below(std::min<std::uint64_t>(40, side - std::uint64_t(rect.y))));
      ASSERT_EQ(wrongIn(pyramid, *tiles, level, rect), 0);
      EXPECT_LE(tiles->bytesHeld(), std::max(budget, kTileBytes));
    }
    EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {0, 0, 513, 513}), 0) << "all tiles, those cut by the rim too";
  }
}

TEST(TePyramidTiles, TilesAreReadOnceWhileTheyAreHeld) {
  const TestPyramid pyramid(9);
  const auto tiles = pyramid.tiles(9);
  ASSERT_TRUE(tiles);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {100, 100, 100, 20}), 0);
  EXPECT_EQ(tiles->statistics().misses, 2);
  EXPECT_EQ(tiles->statistics().hits, 0);
  EXPECT_EQ(tiles->statistics().bytesRead, std::int64_t(2 * kTileBytes));
  EXPECT_EQ(tiles->bytesHeld(), 2 * kTileBytes);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {0, 0, 256, 128}), 0);
  EXPECT_EQ(tiles->statistics().misses, 2);
  EXPECT_EQ(tiles->statistics().hits, 2);
}

TEST(TePyramidTiles, TheTileThatWasNotUsedForLongestGoesFirst) {
  const TestPyramid pyramid(9);
  const auto tiles = pyramid.tiles(9, 2 * kTileBytes);
  ASSERT_TRUE(tiles);
  for (const int x : {0, 128, 0, 256}) // the one at 128 goes
    EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {x, 0, 1, 1}), 0);
  EXPECT_EQ(tiles->statistics().misses, 3);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {0, 0, 1, 1}), 0);
  EXPECT_EQ(tiles->statistics().misses, 3);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {128, 0, 1, 1}), 0);
  EXPECT_EQ(tiles->statistics().misses, 4);
}

TEST(TePyramidTiles, AReadErrorIsNotKept) {
  const TestPyramid pyramid(9);
  const auto tiles = pyramid.tiles(9);
  ASSERT_TRUE(tiles);
  pyramid.resize(9, 513 * 100 * 2); // the north is left
  unsigned char sample[2];
  const TeStatus status = tiles->read(9, {0, 0, 1, 1}, sample, 2);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, testing::HasSubstr(pyramid.file(9)));
  EXPECT_EQ(tiles->bytesHeld(), 0u);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {0, 512, 513, 1}), 0);
  pyramid.write(9);
  EXPECT_EQ(wrongIn(pyramid, *tiles, 9, {0, 0, 1, 1}), 0) << "whole again";
}

TEST(TePyramidTiles, AnEmptyRectangleReadsNothing) {
  const TestPyramid pyramid(3);
  const auto tiles = pyramid.tiles(3);
  ASSERT_TRUE(tiles);
  EXPECT_TRUE(tiles->read(3, {2, 2, 0, 5}, nullptr, 0));
  EXPECT_EQ(tiles->statistics().misses, 0);
}
