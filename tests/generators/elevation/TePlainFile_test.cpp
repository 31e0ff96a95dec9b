#include "generators/elevation/TePlainFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

using testing::AllOf;
using testing::HasSubstr;

namespace {

class TePlainFileTest : public testing::Test {
protected:
  void SetUp() override { std::ofstream(m_path) << "0123456789"; }
  void TearDown() override { std::filesystem::remove_all(m_path); }
  const std::string m_path = testing::TempDir() + "plain-file-" + std::to_string(::getpid());
};

} // namespace

TEST_F(TePlainFileTest, ReadsFromAnyPlace) {
  TeResult<TePlainFile> opened = TePlainFile::open(m_path);
  ASSERT_TRUE(opened) << opened.error().message;
  const TePlainFile file = std::move(*opened);
  EXPECT_EQ(file.bytes(), 10u);
  char text[4] = {};
  ASSERT_TRUE(file.read(6, text, 4));
  EXPECT_EQ(std::string(text, 4), "6789");
  ASSERT_TRUE(file.read(0, text, 1));
  EXPECT_EQ(text[0], '0');
  EXPECT_TRUE(file.read(10, text, 0)) << "nothing, at the end";
}

TEST_F(TePlainFileTest, TheEndAndAFileThatShrinksAreErrors) {
  const TeResult<TePlainFile> file = TePlainFile::open(m_path);
  ASSERT_TRUE(file);
  char text[4] = {};
  const TeStatus beyond = file->read(7, text, 4);
  ASSERT_FALSE(beyond);
  EXPECT_THAT(beyond.error().message, AllOf(HasSubstr(m_path), HasSubstr("the file ends")));
  std::filesystem::resize_file(m_path, 2);
  EXPECT_FALSE(file->read(4, text, 2));
  EXPECT_TRUE(file->read(0, text, 2));
}

TEST_F(TePlainFileTest, WhatIsNoPlainFileIsAnErrorAtOnce) {
  for (const char* what : {"nothing", "folder", "pipe"}) {
    std::filesystem::remove_all(m_path);
    if (std::string(what) == "folder")
      std::filesystem::create_directory(m_path);
    if (std::string(what) == "pipe") {
      ASSERT_EQ(::mkfifo(m_path.c_str(), 0600), 0);
    }
    const TeResult<TePlainFile> file = TePlainFile::open(m_path);
    ASSERT_FALSE(file) << what;
    EXPECT_THAT(file.error().message, HasSubstr(m_path));
  }
}
