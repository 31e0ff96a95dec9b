#include "nodes/clipmap/TePyramidWriter.h"

#include "generators/base/TeHash.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace {

class TePyramidWriterTest : public testing::Test {
protected:
  TePyramidWriterTest() {
    std::string name = (fs::temp_directory_path() / "pyramid-XXXXXX").string();
    m_folder = mkdtemp(name.data());
  }
  ~TePyramidWriterTest() override { fs::remove_all(m_folder); }

  TePyramidPlan plan(int level, int sampleBytes = 2, std::uint64_t fingerprint = 1) const {
    return {(m_folder / "p").string(), level, sampleBytes, fingerprint};
  }
  std::string file(int level) const { return tePyramidLevelFile((m_folder / "p").string(), level); }
  std::string journal() const { return (m_folder / "p.journal").string(); }

  static unsigned char byteOf(int x, int row, int byte) {
    return static_cast<unsigned char>(teMix(std::uint64_t(x) << 40 | std::uint64_t(row) << 8 | byte));
  }
  static std::vector<unsigned char> rowOf(const TePyramidPlan& plan, int row) {
    std::vector<unsigned char> bytes;
    for (int x = 0; x < tePyramidSide(plan.level); ++x)
      for (int byte = 0; byte < plan.sampleBytes; ++byte)
        bytes.push_back(byteOf(x, row, byte));
    return bytes;
  }
  /// Rows up to `end`, and no more.
  static void writeRows(TePyramidWriter& writer, const TePyramidPlan& plan, int end) {
    while (writer.nextRow() < end)
      ASSERT_TRUE(writer.write(rowOf(plan, writer.nextRow()).data()));
  }
  void expectPyramid(const TePyramidPlan& plan) const {
    for (int level = 0; level <= plan.level; ++level) {
      const int step = 1 << (plan.level - level);
      std::string wanted;
      for (int row = 0; row < tePyramidSide(level); ++row)
        for (int x = 0; x < tePyramidSide(level); ++x)
          for (int byte = 0; byte < plan.sampleBytes; ++byte)
            wanted += char(byteOf(x * step, row * step, byte));
      std::ifstream stream(file(level), std::ios::binary);
      const std::string got{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      EXPECT_TRUE(got == wanted) << file(level);
    }
  }

  fs::path m_folder;
};

TEST_F(TePyramidWriterTest, ALevelIsEverySecondSampleAndRowOfTheNext) {
  for (int sampleBytes : {1, 2, 3, 4})
    for (int level : {1, 2, 6}) {
      const TePyramidPlan plan = this->plan(level, sampleBytes);
      TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
      ASSERT_TRUE(writer) << writer.error().message;
      writeRows(*writer, plan, tePyramidSide(level));
      EXPECT_FALSE(fs::exists(file(0)));
      ASSERT_TRUE(writer->finish());
      writer->forget();
      expectPyramid(plan);
      EXPECT_FALSE(fs::exists(file(level + 1)));
      EXPECT_FALSE(fs::exists(journal()));
      fs::remove_all(m_folder);
      fs::create_directory(m_folder);
    }
}

TEST_F(TePyramidWriterTest, ExistingLevelsAreRefused) {
  EXPECT_TRUE(TePyramidWriter::check(plan(4)));
  std::ofstream(file(9)) << "of a larger pyramid";
  const TeStatus refused = TePyramidWriter::check(plan(4));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find(file(9)), std::string::npos);
}

TEST_F(TePyramidWriterTest, WorkOnSomethingElseIsRefusedAndReplaced) {
  {
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan(5));
    ASSERT_TRUE(writer);
    writeRows(*writer, plan(5), 9);
  }
  EXPECT_TRUE(TePyramidWriter::check(plan(5)));
  for (const TePyramidPlan& other : {plan(5, 2, 2), plan(6), plan(5, 3)}) {
    const TeStatus refused = TePyramidWriter::check(other);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find(journal()), std::string::npos);
  }
  const TePyramidPlan other = plan(4, 3, 2);
  TeResult<TePyramidWriter> writer = TePyramidWriter::open(other);
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->nextRow(), 0);
  writeRows(*writer, other, tePyramidSide(4));
  ASSERT_TRUE(writer->finish());
  expectPyramid(other);
  EXPECT_FALSE(fs::exists(TePartFile::partOf(file(5)))); // of what was replaced
}

TEST_F(TePyramidWriterTest, GoesOnAfterTheLastCheckpoint) {
  const TePyramidPlan plan = this->plan(11, 4); // 16.8 MB: one checkpoint on the way
  {
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
    ASSERT_TRUE(writer);
    writeRows(*writer, plan, tePyramidSide(11) - 1);
  }
  const TeResult<TePyramidJournal::State> state = TePyramidJournal::read(journal());
  ASSERT_TRUE(state);
  EXPECT_GT(state->rows, 1000);
  // What came after the checkpoint may be on the disk in part, or be anything.
  std::ofstream(TePartFile::partOf(file(3)), std::ios::app) << "garbage";
  TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
  ASSERT_TRUE(writer) << writer.error().message;
  EXPECT_EQ(writer->nextRow(), state->rows);
  writeRows(*writer, plan, tePyramidSide(11));
  ASSERT_TRUE(writer->finish());
  writer->forget();
  expectPyramid(plan);
}

TEST_F(TePyramidWriterTest, ALostPartMeansToBeginAnew) {
  const TePyramidPlan plan = this->plan(4);
  {
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
    ASSERT_TRUE(writer);
    writeRows(*writer, plan, tePyramidSide(4));
  }
  {
    TeResult<TePyramidJournal> journal = TePyramidJournal::open(this->journal());
    ASSERT_TRUE(journal);
    ASSERT_TRUE(journal->record(9)); // as if there had been a checkpoint
  }
  fs::remove(TePartFile::partOf(file(2)));
  TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->nextRow(), 0);
  writeRows(*writer, plan, tePyramidSide(4));
  ASSERT_TRUE(writer->finish());
  expectPyramid(plan);
}

TEST_F(TePyramidWriterTest, AnInterruptionWhileFilesTakeTheirNamesIsMended) {
  const TePyramidPlan plan = this->plan(4);
  for (int named = 0; named <= 5; ++named) {
    {
      TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
      ASSERT_TRUE(writer);
      writeRows(*writer, plan, tePyramidSide(4));
      ASSERT_TRUE(writer->finish());
    }
    for (int level = named; level <= 4; ++level)
      fs::rename(file(level), TePartFile::partOf(file(level)));
    EXPECT_TRUE(TePyramidWriter::check(plan));
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
    ASSERT_TRUE(writer);
    EXPECT_EQ(writer->nextRow(), tePyramidSide(4)) << named;
    ASSERT_TRUE(writer->finish());
    writer->forget();
    expectPyramid(plan);
    fs::remove(file(0));
  }
}

TEST_F(TePyramidWriterTest, HigherLevelsOfAnOlderPyramidGo) {
  for (int level : {6, 4}) {
    const TePyramidPlan plan = this->plan(level, 2, std::uint64_t(level));
    TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan);
    ASSERT_TRUE(writer);
    writeRows(*writer, plan, tePyramidSide(level));
    ASSERT_TRUE(writer->finish());
    writer->forget();
    expectPyramid(plan);
  }
  EXPECT_FALSE(fs::exists(file(5)));
  EXPECT_FALSE(fs::exists(file(6)));
}

TEST_F(TePyramidWriterTest, DiscardedLeavesNothing) {
  TeResult<TePyramidWriter> writer = TePyramidWriter::open(plan(5));
  ASSERT_TRUE(writer);
  writeRows(*writer, plan(5), 9);
  writer->discard();
  EXPECT_TRUE(fs::is_empty(m_folder));
}

TEST_F(TePyramidWriterTest, WhatCannotBeWrittenIsNamedAndLeavesNothing) {
  TePyramidPlan nowhere = plan(3);
  nowhere.name = "/no/such/folder/p";
  EXPECT_FALSE(TePyramidWriter::open(nowhere));
  fs::create_directories(TePartFile::partOf(file(1)));
  const TeResult<TePyramidWriter> blocked = TePyramidWriter::open(plan(3));
  ASSERT_FALSE(blocked);
  EXPECT_NE(blocked.error().message.find(file(1)), std::string::npos);
  EXPECT_FALSE(fs::exists(journal()));
  EXPECT_FALSE(fs::exists(TePartFile::partOf(file(0))));
}

} // namespace
