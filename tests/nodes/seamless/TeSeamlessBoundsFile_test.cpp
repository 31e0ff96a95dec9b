#include "nodes/seamless/TeSeamlessBoundsFile.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace fs = std::filesystem;

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class TeSeamlessBoundsFileTest : public testing::Test {
protected:
  TeSeamlessBoundsFileTest() : m_layout(*TeSeamlessLayout::create(16, 4, 2)) {
    std::string name = (fs::temp_directory_path() / "bounds-XXXXXX").string();
    m_folder = mkdtemp(name.data());
    m_file = TeSeamlessBoundsFile::nameFor((m_folder / "hills").string(), m_layout);
    std::mt19937 random(4);
    m_bounds = *TeSeamlessBounds::create(m_layout, stressMap(StressField::Rough, 16, random));
  }
  ~TeSeamlessBoundsFileTest() override { fs::remove_all(m_folder); }

  std::string bytes() const {
    std::ifstream stream(m_file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& bytes) const { std::ofstream(m_file, std::ios::binary) << bytes; }
  /// The message, or nothing if it was read.
  std::string fault(const TeSeamlessLayout& layout) const {
    const auto bounds = TeSeamlessBoundsFile::load(layout, m_file);
    return bounds ? std::string() : bounds.error().message;
  }
  std::string fault() const { return fault(m_layout); }

  TeSeamlessLayout m_layout;
  fs::path m_folder;
  std::string m_file;
  std::shared_ptr<const TeSeamlessBounds> m_bounds;
};

} // namespace

TEST_F(TeSeamlessBoundsFileTest, ReadsWhatItWrote) {
  EXPECT_EQ(fs::path(m_file).filename(), "hills_bounds_4_2.bin");
  ASSERT_TRUE(TeSeamlessBoundsFile::save(*m_bounds, m_file).ok());
  const auto read = TeSeamlessBoundsFile::load(m_layout, m_file);
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE((*read)->measured().errors == m_bounds->measured().errors);
  EXPECT_TRUE((*read)->measured().ranges == m_bounds->measured().ranges);
  const TeSideKey middle{1, true, 1, 2};
  EXPECT_EQ((*read)->side(middle).beyond, m_bounds->side(middle).beyond);
  EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()), 1);

  // The sizes stand where the header says, whatever the machine's byte order.
  EXPECT_EQ(bytes().substr(0, 20), std::string("TeSBnds1\x10\0\0\0\x04\0\0\0\x02\0\0\0", 20));
}

TEST_F(TeSeamlessBoundsFileTest, RefusesEveryPrefixAndEveryFlippedBit) {
  ASSERT_TRUE(TeSeamlessBoundsFile::save(*m_bounds, m_file).ok());
  const std::string whole = bytes();
  for (std::size_t size = 0; size < whole.size(); size++) {
    write(whole.substr(0, size));
    ASSERT_THAT(fault(), StartsWith(m_file + (size < 20 ? ": " : ": cut off"))) << size;
  }
  for (std::size_t i = 0; i < whole.size(); i++) {
    std::string damaged = whole;
    damaged[i] = char(damaged[i] ^ (1 << i % 8));
    write(damaged);
    const std::string message = fault();
    ASSERT_THAT(message, StartsWith(m_file + ": ")) << i;
    ASSERT_THAT(message, Not(HasSubstr("\n")));
  }
  write(whole + "x");
  EXPECT_THAT(fault(), HasSubstr("too long"));
  write(whole);
  EXPECT_EQ(fault(), "");
}

TEST_F(TeSeamlessBoundsFileTest, SaysWhatIsWrong) {
  EXPECT_EQ(fault(), m_file + ": No such file or directory");
  write(std::string(5000, 'x'));
  EXPECT_EQ(fault(), m_file + ": no bounds of seamless patches, or of another version");
  ASSERT_TRUE(TeSeamlessBoundsFile::save(*m_bounds, m_file).ok());
  EXPECT_EQ(fault(*TeSeamlessLayout::create(64, 4, 2)),
            m_file + ": measured for resolution 16, minimum patch resolution 4 and 2 levels, or damaged; "
                     "wanted are 64, 4 and 2");
  EXPECT_THAT(fault(*TeSeamlessLayout::create(1 << 22, 2, 2)), HasSubstr("too many patches"));

  const fs::path folder = m_folder / "folder";
  fs::create_directory(folder);
  EXPECT_EQ(TeSeamlessBoundsFile::save(*m_bounds, folder.string()).error().message,
            folder.string() + ": cannot be written: Is a directory");
  const std::string nowhere = (m_folder / "none" / "file").string();
  EXPECT_EQ(TeSeamlessBoundsFile::save(*m_bounds, nowhere).error().message,
            nowhere + ": cannot be written: No such file or directory");
}

TEST_F(TeSeamlessBoundsFileTest, KeepsTheOldFileWhenTheNewOneFails) {
  ASSERT_TRUE(TeSeamlessBoundsFile::save(*m_bounds, m_file).ok());
  const std::string old = bytes();
  fs::create_directory(m_file + ".part");
  EXPECT_FALSE(TeSeamlessBoundsFile::save(*m_bounds, m_file).ok());
  EXPECT_EQ(bytes(), old);
}
