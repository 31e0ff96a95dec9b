#include "engine/input/TeRecorder.h"

#include "engine/input/TeTestRecording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <sys/resource.h>
#include <sys/stat.h>

namespace {

using testing::HasSubstr;
using testing::StartsWith;

class TeRecorderTest : public testing::Test {
protected:
  std::unique_ptr<TeRecorder> create(const std::string& file) {
    auto made = TeRecorder::create(file, m_test.settings);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    return made ? std::move(*made) : nullptr;
  }
  std::string errorOf(const std::string& file) {
    const auto made = TeRecorder::create(file, m_test.settings);
    return made ? "" : made.error().message;
  }

  TeTestRecording m_test;
};

TEST_F(TeRecorderTest, WritesReadableText) {
  const std::string file = m_test.path("run.rec");
  const auto recorder = create(file);
  for (const TeRecordedFrame& frame : m_test.frames)
    recorder->add(frame);
  ASSERT_TRUE(recorder->finish());
  EXPECT_THAT(TeTestRecording::read(file),
              StartsWith("terrane recording 1\n"
                         "setting empty \n"
                         "setting generator noise:type=ridged + band(0.5)\n"
                         "setting seed 18446744073709551615\n"
                         "frames\n"
                         "0.03333333333333333 #0000000000000123 +UP_ARROW +A/sca\n"
                         "0.1 #ffffffffffffffff\n"
                         "0 -A/c\n"
                         "5e-324 #0000000000000000 +0x1a2b\n"
                         "end 4 "));
}

TEST_F(TeRecorderTest, TheTargetIsNeverHalfARecording) {
  const std::string file = m_test.write("run.rec", "an older recording");
  {
    const auto recorder = create(file);
    recorder->add(m_test.frames[0]);
    EXPECT_EQ(TeTestRecording::read(file), "an older recording");
    EXPECT_EQ(m_test.files(), 2);
  } // never finished
  EXPECT_EQ(TeTestRecording::read(file), "an older recording");
  EXPECT_EQ(m_test.files(), 1);
  const auto recorder = create(file);
  ASSERT_TRUE(recorder->finish());
  EXPECT_THAT(TeTestRecording::read(file), StartsWith("terrane recording"));
  EXPECT_EQ(m_test.files(), 1);
}

TEST_F(TeRecorderTest, AnUnwritableTargetIsAnErrorAtOnce) {
  const std::string nowhere = m_test.path("no/such/run.rec");
  EXPECT_EQ(errorOf(nowhere), nowhere + ": cannot be written: No such file or directory");
  EXPECT_THAT(errorOf(m_test.folder().string()), HasSubstr(": cannot be written: it is not a plain file"));
  EXPECT_THAT(errorOf("/dev/null"), HasSubstr("/dev/null: cannot be written: it is not a plain file"));
  EXPECT_THAT(errorOf(m_test.write("file", "") + "/run.rec"), HasSubstr("Not a directory"));
  EXPECT_THAT(errorOf(""), HasSubstr("cannot be written"));
}

TEST_F(TeRecorderTest, SettingsThatWouldNotReadBackAreRefused) {
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, std::string>>{{"two words", "1"},
                                                        {"", "1"},
                                                        {"seed", "1\n2"},
                                                        {"se\ned", "1"},
                                                        {"seed", std::string(1, '\0')}}) {
    const auto made = TeRecorder::create(m_test.path("run.rec"), {{name, value}});
    ASSERT_FALSE(made) << name;
    EXPECT_THAT(made.error().message, StartsWith(m_test.path("run.rec") + ": cannot be recorded: "));
  }
  EXPECT_EQ(m_test.files(), 0);
}

TEST_F(TeRecorderTest, FramesThatAreNoneAreOneErrorAtTheEnd) {
  const auto recorder = create(m_test.path("run.rec"));
  recorder->add(m_test.frames[0]);
  recorder->add({-1, {}, {}});
  recorder->add({std::numeric_limits<double>::quiet_NaN(), {}, {}});
  recorder->add(m_test.frames[1]);
  EXPECT_EQ(recorder->finish().error().message,
            m_test.path("run.rec") + ": cannot be written: a frame's time must be finite and not negative");
  EXPECT_EQ(m_test.files(), 0);
  EXPECT_THAT(recorder->finish().error().message, HasSubstr("finished already"));
}

// A limit on the size of files stands for a full disk: writing fails in the middle of the run.
TEST_F(TeRecorderTest, AFullDiskIsOneErrorAtTheEndAndNothingElse) {
  const std::string file = m_test.write("run.rec", "an older recording");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100'000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto recorder = create(file);
  for (int i = 0; i < 20'000; ++i)
    recorder->add(m_test.frames[0]);
  const TeStatus finished = recorder->finish();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message, file + ": cannot be written: File too large");
  EXPECT_EQ(TeTestRecording::read(file), "an older recording");
  EXPECT_EQ(m_test.files(), 1);
}

TEST_F(TeRecorderTest, AFolderThatGoesAwayIsAnErrorAtTheEnd) {
  std::filesystem::create_directory(m_test.path("sub"));
  const auto recorder = create(m_test.path("sub/run.rec"));
  std::filesystem::remove_all(m_test.path("sub"));
  recorder->add(m_test.frames[0]);
  EXPECT_THAT(recorder->finish().error().message, HasSubstr("sub/run.rec: cannot be written: No such file"));
}

} // namespace
