#include "generators/base/TePartFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;

namespace {

class TePartFileTest : public testing::Test {
protected:
  TePartFileTest() {
    std::string name = (fs::temp_directory_path() / "part-XXXXXX").string();
    m_folder = mkdtemp(name.data());
  }
  ~TePartFileTest() override { fs::remove_all(m_folder); }

  std::string path(const std::string& name) const { return (m_folder / name).string(); }
  static std::string contents(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

private:
  fs::path m_folder;
};

TEST_F(TePartFileTest, AppearsWholeOrNotAtAll) {
  const std::string file = path("a.raw");
  std::ofstream(file) << "before";
  TeResult<TePartFile> part = TePartFile::open(file);
  ASSERT_TRUE(part) << part.error().message;
  ASSERT_TRUE(part->write("hello ", 6));
  ASSERT_TRUE(part->write("world", 5));
  EXPECT_EQ(part->bytes(), 11u);
  ASSERT_TRUE(part->flush());
  EXPECT_EQ(contents(file), "before");
  EXPECT_EQ(contents(TePartFile::partOf(file)), "hello world");
  ASSERT_TRUE(part->finish());
  EXPECT_EQ(contents(file), "hello world");
  EXPECT_FALSE(fs::exists(TePartFile::partOf(file)));
}

TEST_F(TePartFileTest, GoesOnWithWhatIsKept) {
  const std::string file = path("a.raw");
  {
    TeResult<TePartFile> part = TePartFile::open(file);
    ASSERT_TRUE(part);
    ASSERT_TRUE(part->write("0123456789", 10));
    ASSERT_TRUE(part->flush());
  }
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(TePartFile::open(file, 11));
  TeResult<TePartFile> part = TePartFile::open(file, 4);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->bytes(), 4u);
  ASSERT_TRUE(part->write("abc", 3));
  ASSERT_TRUE(part->finish());
  EXPECT_EQ(contents(file), "0123abc");
}

TEST_F(TePartFileTest, WritesMoreThanItsBuffer) {
  std::string text;
  for (int i = 0; i < 100000; ++i)
    text += std::to_string(i);
  const std::string file = path("a.raw");
  TeResult<TePartFile> part = TePartFile::open(file);
  ASSERT_TRUE(part);
  for (std::size_t at = 0; at < text.size(); at += 997)
    ASSERT_TRUE(part->write(text.data() + at, std::min<std::size_t>(997, text.size() - at)));
  TePartFile moved = std::move(*part);
  ASSERT_TRUE(moved.finish());
  EXPECT_EQ(contents(file), text);
}

TEST_F(TePartFileTest, DiscardedLeavesNothing) {
  const std::string file = path("a.raw");
  TeResult<TePartFile> part = TePartFile::open(file);
  ASSERT_TRUE(part);
  part->discard();
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(fs::exists(TePartFile::partOf(file)));
}

TEST_F(TePartFileTest, OnlyOneMayWrite) {
  const std::string file = path("a.raw");
  TeResult<TePartFile> first = TePartFile::open(file);
  ASSERT_TRUE(first);
  ASSERT_TRUE(first->write("first", 5));
  ASSERT_TRUE(first->flush());
  const TeResult<TePartFile> second = TePartFile::open(file);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find(TePartFile::partOf(file)), std::string::npos);
  ASSERT_TRUE(first->finish());
  EXPECT_EQ(contents(file), "first");
  EXPECT_TRUE(TePartFile::open(file));
  EXPECT_EQ(contents(file), "first");
}

TEST_F(TePartFileTest, DoesNotWriteThroughLinks) {
  std::ofstream(path("precious")) << "kept";
  fs::create_symlink(path("precious"), TePartFile::partOf(path("a.raw")));
  const TeStatus refused = TePartFile::writeWhole(path("a.raw"), "text");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("a.raw.part"), std::string::npos);
  EXPECT_EQ(contents(path("precious")), "kept");
}

TEST_F(TePartFileTest, WhatCannotBeWrittenIsNamed) {
  const TeResult<TePartFile> missing = TePartFile::open("/no/such/folder/a.raw");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("/no/such/folder/a.raw"), std::string::npos);
  const std::string folder = path("folder");
  fs::create_directories(TePartFile::partOf(folder));
  EXPECT_FALSE(TePartFile::open(folder));
  // A folder stands where the file is to go.
  fs::create_directories(path("full/inside"));
  const TeStatus blocked = TePartFile::writeWhole(path("full"), "text");
  ASSERT_FALSE(blocked);
  EXPECT_NE(blocked.error().message.find(path("full")), std::string::npos);
  EXPECT_FALSE(fs::exists(TePartFile::partOf(path("full"))));
}

} // namespace
