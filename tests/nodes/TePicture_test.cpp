#include "nodes/TePicture.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

TePicture gradient(int width, int height) {
  TePicture picture;
  picture.width = width;
  picture.height = height;
  for (int i = 0; i < 4 * width * height; i++)
    picture.rgba.push_back(std::uint8_t(i * 7 + i / 64));
  return picture;
}

std::string temporary(const char* name) { return testing::TempDir() + name; }

} // namespace

TEST(TePicture, PngKeepsEveryPixel) {
  const TePicture picture = gradient(17, 9);
  const std::string path = temporary("picture.png");
  ASSERT_TRUE(picture.writePng(path));
  const TeResult<TePicture> read = TePicture::readPng(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, picture);
  std::filesystem::remove(path);
}

TEST(TePicture, FailingWritesNameTheFile) {
  for (const char* path : {"/nonexistent/folder/a.png", "/dev/full"}) {
    const TeStatus status = gradient(300, 300).writePng(path);
    ASSERT_FALSE(status) << path;
    EXPECT_NE(status.error().message.find(path), std::string::npos) << status.error().message;
  }
  EXPECT_FALSE(TePicture().writePng(temporary("empty.png")));
}

TEST(TePicture, PicturesWithoutAllTheirPixelsAreNotWritten) {
  TePicture picture = gradient(5, 4);
  picture.rgba.pop_back();
  const std::string path = temporary("short.png");
  EXPECT_FALSE(picture.writePng(path));
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TePicture, EveryPrefixOfAPngIsAnError) {
  const std::string path = temporary("whole.png");
  ASSERT_TRUE(gradient(5, 5).writePng(path));
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string cut = temporary("cut.png");
  // Decoders may do without the last chunk, which carries nothing.
  const std::size_t end = bytes.size() - 12;
  for (std::size_t length = 0; length < end; length++) {
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, length);
    EXPECT_FALSE(TePicture::readPng(cut)) << length;
  }
  std::filesystem::remove(path);
  std::filesystem::remove(cut);
}

TEST(TePicture, MissingFileIsAnError) {
  const TeResult<TePicture> read = TePicture::readPng("/nonexistent.png");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("/nonexistent.png"), std::string::npos);
}
