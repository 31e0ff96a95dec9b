#include "nodes/seamless/TeSeamlessHeightFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

/// A file that is removed in the end.
class TestFile {
public:
  TestFile(const std::string& name, const std::string& bytes) : m_path(testing::TempDir() + name) {
    std::ofstream(m_path, std::ios::binary) << bytes;
  }
  ~TestFile() { std::filesystem::remove(m_path); }
  TestFile(const TestFile&) = delete;
  TestFile& operator=(const TestFile&) = delete;
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

std::string rawNumbers(int side) {
  std::string bytes;
  for (int i = 0; i < side * side; i++) {
    bytes.push_back(char(i * 200 & 255));
    bytes.push_back(char(i * 200 >> 8));
  }
  return bytes;
}

} // namespace

TEST(TeSeamlessHeightFile, RawNumbersFromTheNorthWithoutSign) {
  const TestFile file("heights.RAW", rawNumbers(17));
  const auto read = TeSeamlessHeightFile::read(file.path(), 0);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->isRaw);
  EXPECT_EQ(read->spacing, 0);
  EXPECT_EQ(read->map.width(), 17);
  EXPECT_EQ(read->map.at(0, 16), 0);
  EXPECT_EQ(read->map.at(1, 16), 200);
  EXPECT_EQ(read->map.at(16, 0), 57600); // above 32767, and no -7936
  const auto metres = TeSeamlessHeightFile::read(file.path(), 0.5);
  ASSERT_TRUE(metres);
  EXPECT_EQ(metres->map.at(1, 16), 100);
}

TEST(TeSeamlessHeightFile, NoSquareIsAnError) {
  const std::string bytes = rawNumbers(17);
  for (const std::string& wrong :
       {bytes.substr(1), bytes + "x", std::string(), rawNumbers(16), rawNumbers(18)}) {
    const TestFile file("wrong.raw", wrong);
    const auto read = TeSeamlessHeightFile::read(file.path(), 0);
    ASSERT_FALSE(read) << wrong.size();
    EXPECT_THAT(read.error().message, testing::HasSubstr("wrong.raw"));
  }
  EXPECT_FALSE(TeSeamlessHeightFile::read(testing::TempDir() + "absent.raw", 0));
}

#ifdef TERRANE_TEST_WITH_GDAL
namespace {

std::string asciiGrid(int columns, int rows, const std::string& first) {
  std::string text = "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) +
                     "\nxllcorner 1000\nyllcorner 5000\ncellsize 25\nNODATA_value -9999\n";
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < columns; column++)
      text += (row + column == 0 ? first : std::to_string(row * 100 + column)) + " ";
    text += "\n";
  }
  return text;
}

} // namespace

TEST(TeSeamlessHeightFile, ElevationDataHasMetresAndSpacing) {
  const TestFile file("grid.asc", asciiGrid(33, 33, "7"));
  const auto read = TeSeamlessHeightFile::read(file.path(), 0);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_FALSE(read->isRaw);
  EXPECT_EQ(read->spacing, 25);
  EXPECT_EQ(read->map.at(0, 32), 7); // the first one lies in the north-west
  EXPECT_EQ(read->map.at(5, 32 - 3), 305);
}

TEST(TeSeamlessHeightFile, ElevationDataOfOtherSizesAndWithHolesAreErrors) {
  const TestFile oblong("oblong.asc", asciiGrid(33, 32, "7"));
  const auto read = TeSeamlessHeightFile::read(oblong.path(), 0);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, testing::HasSubstr("33x32"));
  const TestFile hole("hole.asc", asciiGrid(33, 33, "-9999"));
  const auto holed = TeSeamlessHeightFile::read(hole.path(), 0);
  ASSERT_FALSE(holed);
  EXPECT_THAT(holed.error().message, testing::HasSubstr("1 samples are missing"));
}
#endif
