#include "nodes/clipmap/TeClipImage.h"

#include "nodes/clipmap/testPyramid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

int wrongSamples(const TestPyramid& pyramid, const TeClipImage& image) {
  const TeSampleRect& held = image.held();
  int wrong = 0;
  for (std::int32_t y = held.y; y < held.y + held.rows; y++)
    for (std::int32_t x = held.x; x < held.x + held.columns; x++) {
      const unsigned char* bytes = image.sample(x, y);
      wrong +=
          !bytes || bytes != image.place(x % 16, y % 16) || !pyramid.isSample(bytes, image.level(), x, y);
    }
  return wrong;
}

std::int64_t count(const std::vector<TeSampleRect>& places) {
  std::int64_t samples = 0;
  for (const TeSampleRect& place : places) {
    EXPECT_TRUE(place.x >= 0 && place.y >= 0 && place.x + place.columns <= 16 && place.y + place.rows <= 16);
    EXPECT_FALSE(place.isEmpty());
    samples += place.count();
  }
  return samples;
}

} // namespace

TEST(TeClipImage, TakesWholeRowsAndColumnsUntilItHasTheWindow) {
  const TestPyramid pyramid(6);
  const auto tiles = pyramid.tiles(6);
  TeClipImage image(6, 16, 2);
  std::vector<TeSampleRect> places;
  EXPECT_EQ(*image.follow(*tiles, {9, 20, 16, 16}, 15, places), 0) << "less than a row";
  EXPECT_EQ(*image.follow(*tiles, {9, 20, 16, 16}, 100, places), 96);
  EXPECT_FALSE(image.isWhole());
  EXPECT_EQ(wrongSamples(pyramid, image), 0);
  EXPECT_EQ(*image.follow(*tiles, {9, 20, 16, 16}, 1000, places), 160);
  EXPECT_TRUE(image.isWhole());
  EXPECT_EQ(wrongSamples(pyramid, image), 0);
  EXPECT_EQ(count(places), 256);

  places.clear();
  EXPECT_EQ(*image.follow(*tiles, {11, 19, 16, 16}, 1000, places), 2 * 16 + 16 - 2);
  EXPECT_EQ(count(places), 46) << "two columns, a row, their corner once";
  EXPECT_LE(places.size(), 6u) << "columns and row, each split where they cross a border";
  EXPECT_EQ(image.held(), (TeSampleRect{11, 19, 16, 16}));
  EXPECT_EQ(wrongSamples(pyramid, image), 0);
  EXPECT_EQ(image.sample(10, 25), nullptr);
  EXPECT_EQ(image.sample(27, 25), nullptr);

  places.clear();
  EXPECT_EQ(*image.follow(*tiles, {11, 19, 16, 16}, 1000, places), 0);
  EXPECT_TRUE(places.empty());
}

TEST(TeClipImage, AWholeLevelIsReadOrTakenFromAHigherOne) {
  const TestPyramid pyramid(6);
  const auto tiles = pyramid.tiles(3);
  for (const int from : {3, 4, 6}) {
    TeClipImage image(3, 16, 2);
    ASSERT_TRUE(image.loadWhole(*tiles, from));
    EXPECT_EQ(image.held(), (TeSampleRect{0, 0, 9, 9}));
    EXPECT_EQ(wrongSamples(pyramid, image), 0) << from;
  }
}

TEST(TeClipImage, HasNothingAfterAReadError) {
  const TestPyramid pyramid(6);
  const auto tiles = pyramid.tiles(6);
  pyramid.resize(6, 65 * 10 * 2);
  TeClipImage image(6, 16, 2);
  std::vector<TeSampleRect> places;
  const auto taken = image.follow(*tiles, {9, 20, 16, 16}, 1000, places);
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().message, testing::HasSubstr(pyramid.file(6)));
  EXPECT_TRUE(image.hasFailed());
  EXPECT_TRUE(image.held().isEmpty());
}
