#include "nodes/clipmap/TePyramidJournal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace {

class TePyramidJournalTest : public testing::Test {
protected:
  TePyramidJournalTest() {
    std::string name = (fs::temp_directory_path() / "journal-XXXXXX").string();
    m_folder = mkdtemp(name.data());
    m_path = (m_folder / "a.journal").string();
  }
  ~TePyramidJournalTest() override { fs::remove_all(m_folder); }

  void put(const std::string& text) const { std::ofstream(m_path, std::ios::binary) << text; }
  std::string get() const {
    std::ifstream stream(m_path);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  fs::path m_folder;
  std::string m_path;
};

TEST_F(TePyramidJournalTest, TellsWhatWasBegunAndTheLastCheckpoint) {
  TeResult<TePyramidJournal::State> state = TePyramidJournal::read(m_path);
  ASSERT_TRUE(state);
  EXPECT_FALSE(state->exists);
  TeResult<TePyramidJournal> journal = TePyramidJournal::open(m_path);
  ASSERT_TRUE(journal) << journal.error().message;
  ASSERT_TRUE(journal->begin(0xfedcba9876543210));
  ASSERT_TRUE(journal->record(512));
  ASSERT_TRUE(journal->record(1024));
  state = TePyramidJournal::read(m_path);
  ASSERT_TRUE(state);
  EXPECT_TRUE(state->exists);
  EXPECT_EQ(state->fingerprint, 0xfedcba9876543210);
  EXPECT_EQ(state->rows, 1024);
  ASSERT_TRUE(journal->begin(7));
  state = TePyramidJournal::read(m_path);
  EXPECT_EQ(state->fingerprint, 7u);
  EXPECT_EQ(state->rows, 0);
  journal->remove();
  EXPECT_FALSE(fs::exists(m_path));
}

TEST_F(TePyramidJournalTest, EveryPrefixIsAnEarlierStateOrNothing) {
  {
    TeResult<TePyramidJournal> journal = TePyramidJournal::open(m_path);
    ASSERT_TRUE(journal);
    ASSERT_TRUE(journal->begin(42));
    ASSERT_TRUE(journal->record(100));
    ASSERT_TRUE(journal->record(2000));
  }
  const std::string whole = get();
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    put(whole.substr(0, length));
    const TeResult<TePyramidJournal::State> state = TePyramidJournal::read(m_path);
    ASSERT_TRUE(state) << length << " " << state.error().message;
    EXPECT_EQ(state->exists, length > whole.find('\n'));
    EXPECT_EQ(state->rows, length == whole.size() ? 2000 : length + 5 >= whole.size() ? 100 : 0) << length;
  }
}

TEST_F(TePyramidJournalTest, GoesOnAfterALineThatWasCutOff) {
  put("terrane pyramid 000000000000002a\n100\n20");
  TeResult<TePyramidJournal> journal = TePyramidJournal::open(m_path);
  ASSERT_TRUE(journal) << journal.error().message;
  ASSERT_TRUE(journal->record(200));
  EXPECT_EQ(get(), "terrane pyramid 000000000000002a\n100\n200\n");
}

TEST_F(TePyramidJournalTest, OtherFilesAreNoJournals) {
  for (const char* text : {"a diary\n", "x", "terrane pyramid\n", "terrane pyramid xyz\n",
                           "terrane pyramid 000000000000002a\n-3\n", "terrane pyramid 2a\nmany\n"}) {
    put(text);
    EXPECT_FALSE(TePyramidJournal::read(m_path)) << text;
  }
}

TEST_F(TePyramidJournalTest, OnlyOneMayWrite) {
  TeResult<TePyramidJournal> first = TePyramidJournal::open(m_path);
  ASSERT_TRUE(first);
  const TeResult<TePyramidJournal> second = TePyramidJournal::open(m_path);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find(m_path), std::string::npos);
  first->remove();
  EXPECT_TRUE(TePyramidJournal::open(m_path));
  EXPECT_FALSE(TePyramidJournal::open("/no/such/folder/a.journal"));
}

} // namespace
