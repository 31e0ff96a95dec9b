#include "nodes/clipmap/TePyramidReader.h"

#include "nodes/clipmap/testPyramid.h"
#include "nodes/logLines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>
#include <string>
#include <vector>

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string errorOf(const std::string& name, int bytes, int whole, int top = -1) {
  const TeResult<TePyramidReader> reader = TePyramidReader::open(name, bytes, whole, top);
  return reader ? "" : reader.error().message;
}

} // namespace

TEST(TePyramidReader, ReadsAnyRectangleWithItsFirstRowInTheSouth) {
  for (const int bytes : {2, 3, 4}) {
    const TestPyramid pyramid(5, bytes);
    const LogLines log;
    const TeResult<TePyramidReader> reader = TePyramidReader::open(pyramid.name(), bytes, 3);
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(reader->baseLevel(), 3);
    EXPECT_EQ(reader->topLevel(), 5);
    const TeSampleRect rects[] = {{0, 0, 33, 33}, {5, 9, 3, 7}, {32, 32, 1, 1}, {0, 16, 33, 1}};
    for (const TeSampleRect& rect : rects) {
      std::vector<unsigned char> samples(std::size_t(40 * bytes) * std::size_t(rect.rows), 0xee);
      ASSERT_TRUE(reader->read(5, rect, samples.data(), std::size_t(40 * bytes)));
      int wrong = 0;
      for (int y = 0; y < rect.rows; y++)
        for (int x = 0; x < rect.columns; x++)
          wrong += !pyramid.isSample(&samples[std::size_t((y * 40 + x) * bytes)], 5, rect.x + x, rect.y + y);
      EXPECT_EQ(wrong, 0);
      EXPECT_EQ(samples[std::size_t(rect.columns * bytes)], 0xee)
          << "nothing beside the rectangle is written";
    }
    EXPECT_TRUE(log.lines.empty());
  }
}

TEST(TePyramidReader, ALevelThatCannotBeUsedIsReportedOnceAndThoseAboveAreNotUsed) {
  const TestPyramid pyramid(6);
  const auto topWith = [&](auto damage) {
    for (int level = 0; level <= 6; level++) {
      std::filesystem::remove_all(pyramid.file(level));
      pyramid.write(level);
    }
    damage();
    const LogLines log;
    const TeResult<TePyramidReader> reader = TePyramidReader::open(pyramid.name(), 2, 3);
    EXPECT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(log.lines.size(), 1u);
    EXPECT_THAT(log.lines,
                ElementsAre(AllOf(HasSubstr(pyramid.file(reader->topLevel() + 1)),
                                  HasSubstr("level " + std::to_string(reader->topLevel()) + " stands"))));
    return reader->topLevel();
  };
  EXPECT_EQ(topWith([&] { std::filesystem::remove(pyramid.file(5)); }), 4);
  EXPECT_EQ(topWith([&] { pyramid.resize(6, 8449); }), 5);
  EXPECT_EQ(topWith([&] { pyramid.resize(4, 17 * 17 * 2 + 1); }), 3);
  EXPECT_EQ(topWith([&] { pyramid.resize(5, 33 * 33 * 3); }), 4) << "a foreign file";
  EXPECT_EQ(topWith([&] { pyramid.resize(5, 0); }), 4);
  EXPECT_EQ(topWith([&] {
              std::filesystem::remove(pyramid.file(5));
              std::filesystem::create_directory(pyramid.file(5));
            }),
            4);
  EXPECT_EQ(topWith([&] { std::filesystem::remove(pyramid.file(3)); }), 2) << "the base itself";
}

TEST(TePyramidReader, LevelsBelowTheBaseNeedNotBeThere) {
  const TestPyramid pyramid(6);
  for (int level = 0; level < 4; level++)
    std::filesystem::remove(pyramid.file(level));
  const LogLines log;
  const TeResult<TePyramidReader> reader = TePyramidReader::open(pyramid.name(), 2, 4);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->baseLevel(), 4);
  EXPECT_EQ(reader->topLevel(), 6);
  EXPECT_TRUE(log.lines.empty());
}

TEST(TePyramidReader, ASmallPyramidIsItsOwnBase) {
  const TestPyramid pyramid(4);
  const LogLines log;
  const TeResult<TePyramidReader> reader = TePyramidReader::open(pyramid.name(), 2, 9);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->baseLevel(), 4);
  EXPECT_EQ(reader->topLevel(), 4);
  EXPECT_TRUE(log.lines.empty());
}

TEST(TePyramidReader, AWantedLevelThatIsNotThereIsReported) {
  const TestPyramid pyramid(5);
  LogLines log;
  const TeResult<TePyramidReader> fewer = TePyramidReader::open(pyramid.name(), 2, 3, 4);
  ASSERT_TRUE(fewer);
  EXPECT_EQ(fewer->topLevel(), 4);
  EXPECT_TRUE(log.lines.empty());
  const TeResult<TePyramidReader> more = TePyramidReader::open(pyramid.name(), 2, 3, 7);
  ASSERT_TRUE(more);
  EXPECT_EQ(more->topLevel(), 5);
  EXPECT_THAT(log.lines, ElementsAre(AllOf(HasSubstr(pyramid.file(6)), HasSubstr("and those above"))));
}

TEST(TePyramidReader, NothingUsableIsAnErrorThatNamesTheFile) {
  const TestPyramid pyramid(3);
  EXPECT_THAT(errorOf(pyramid.folder() + "/nothing", 2, 9), HasSubstr(pyramid.folder() + "/nothing_0.raw"));
  EXPECT_THAT(errorOf(pyramid.name(), 4, 9),
              AllOf(HasSubstr("p_0.raw"), HasSubstr("8 bytes instead of the 16")));
  EXPECT_THAT(errorOf("", 2, 9), HasSubstr("empty"));
  for (const int bytes : {INT_MIN, 0, 1, 5, INT_MAX})
    EXPECT_THAT(errorOf(pyramid.name(), bytes, 9), HasSubstr(std::to_string(bytes)));
  for (const int level : {INT_MIN, -2, 23, INT_MAX}) {
    EXPECT_THAT(errorOf(pyramid.name(), 2, 9, level), HasSubstr(std::to_string(level)));
    EXPECT_THAT(errorOf(pyramid.name(), 2, level), HasSubstr(std::to_string(level)));
  }
}

TEST(TePyramidReader, AFileThatShrinksWhileItIsOpenIsAnError) {
  const TestPyramid pyramid(5);
  const TeResult<TePyramidReader> reader = TePyramidReader::open(pyramid.name(), 2, 4);
  ASSERT_TRUE(reader);
  pyramid.resize(5, 33 * 20 * 2);
  std::vector<unsigned char> samples(33 * 33 * 2);
  EXPECT_TRUE(reader->read(5, {0, 13, 33, 20}, samples.data(), 66));
  const TeStatus status = reader->read(5, {0, 0, 33, 33}, samples.data(), 66);
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message, AllOf(HasSubstr(pyramid.file(5)), HasSubstr("the file ends")));
}

TEST(TePyramidReader, TellsColoursOfThreeAndFourBytesApart) {
  for (const int bytes : {3, 4}) {
    const TestPyramid pyramid(5, bytes);
    const TeResult<int> found = TePyramidReader::colourBytes(pyramid.name(), 9);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(*found, bytes);
  }
  const TestPyramid heights(3);
  EXPECT_FALSE(TePyramidReader::colourBytes(heights.name(), 9));
  EXPECT_FALSE(TePyramidReader::colourBytes(heights.folder() + "/nothing", 9));
}
