#include "engine/input/TeReplay.h"

#include "engine/input/TeRecorder.h"
#include "engine/input/TeTestRecording.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

namespace {

using testing::ContainerEq;
using testing::HasSubstr;
using testing::StartsWith;

class TeReplayTest : public testing::Test {
protected:
  /// The text of the test's run.
  std::string record() {
    const auto recorder = TeRecorder::create(m_test.path("run.rec"), m_test.settings);
    EXPECT_TRUE(recorder);
    for (const TeRecordedFrame& frame : m_test.frames)
      (*recorder)->add(frame);
    EXPECT_TRUE((*recorder)->finish());
    return TeTestRecording::read(m_test.path("run.rec"));
  }
  TeResult<TeReplay> replay(const std::string& text) {
    return TeReplay::read(m_test.write("run.rec", text), m_test.settings);
  }
  /// The error without the file's path; empty if there is none.
  std::string errorOf(const std::string& text) {
    const TeResult<TeReplay> read = replay(text);
    if (read)
      return "";
    const std::string file = m_test.path("run.rec");
    EXPECT_THAT(read.error().message, StartsWith(file + ":"));
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
    return read.error().message.substr(file.size() + 1);
  }

  TeTestRecording m_test;
};

TEST_F(TeReplayTest, GivesBackWhatWasRecordedToTheBit) {
  const TeResult<TeReplay> read = replay(record());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(read->frames(), ContainerEq(m_test.frames));
}

TEST_F(TeReplayTest, ARunOfNothingIsARecording) {
  m_test.frames.clear();
  m_test.settings.clear();
  const TeResult<TeReplay> read = replay(record());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(read->frames().empty());
}

TEST_F(TeReplayTest, TellsWhereARunLeavesTheRecording) {
  const TeResult<TeReplay> read = replay(record());
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->compare(0, 0x123));
  EXPECT_TRUE(read->compare(2, 12345)) << "recorded without a hash";
  EXPECT_EQ(read->compare(1, 7).error().message,
            m_test.path("run.rec") +
                ":7: the run differs from the recording in frame 1: state 0000000000000007, recorded "
                "ffffffffffffffff");
  EXPECT_THAT(read->compare(4, 0).error().message, HasSubstr("goes on after the recording's 4 frames"));
}

TEST_F(TeReplayTest, OtherSettingsAreNamed) {
  const std::string text = record();
  m_test.settings["seed"] = "7";
  EXPECT_EQ(errorOf(text), "2: recorded with seed \"18446744073709551615\", but this run has \"7\"");
  m_test.settings.erase("seed");
  EXPECT_EQ(errorOf(text), "2: recorded with seed \"18446744073709551615\", which this run does not have");
  m_test.settings["seed"] = "18446744073709551615";
  m_test.settings["radius"] = "3";
  EXPECT_EQ(errorOf(text), "2: recorded without radius, but this run has \"3\"");
}

TEST_F(TeReplayTest, OtherFilesAreNamed) {
  EXPECT_EQ(errorOf("\x89PNG\r\n\x1a\n"), "1: this is not a recording of Terrane");
  EXPECT_EQ(errorOf("hello"), "1: this is not a recording of Terrane");
  EXPECT_EQ(errorOf(std::string(100, '\0')), "1: this is not a recording of Terrane");
  EXPECT_EQ(errorOf(""), "1: the recording was cut off: its end is missing");
  EXPECT_EQ(errorOf("terrane recording 2\n"),
            "1: a recording of version \"2\"; this program reads version 1");
  const TeResult<TeReplay> missing = TeReplay::read(m_test.path("missing"), {});
  EXPECT_EQ(missing.error().message, m_test.path("missing") + ": cannot be read: No such file or directory");
  for (const char* file : {"/dev/zero", "/tmp"})
    EXPECT_EQ(TeReplay::read(file, {}).error().message,
              std::string(file) + ": cannot be read: it is not a plain file");
}

TEST_F(TeReplayTest, EveryBeginningIsAnError) {
  const std::string text = record();
  for (std::size_t bytes = 0; bytes < text.size(); ++bytes) {
    const std::string error = errorOf(text.substr(0, bytes));
    ASSERT_THAT(error, HasSubstr("the recording was cut off")) << bytes;
  }
}

TEST_F(TeReplayTest, EveryChangedByteIsAnError) {
  const std::string text = record();
  int changes = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    for (int change = 1; change < 256; change = change < 8 ? change + 1 : change * 2 + 1) {
      std::string changed = text;
      changed[at] = char(changed[at] ^ change);
      ASSERT_NE(errorOf(changed), "") << "byte " << at << " changed by " << change;
      ++changes;
    }
  std::printf("%zu bytes: %zu beginnings and %d changes are errors\n", text.size(), text.size(), changes);
}

TEST_F(TeReplayTest, LinesThatAreLostAddedOrSwappedAreErrors) {
  const std::string text = record();
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts)
      all += part;
    return all;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::string> without = lines;
    without.erase(without.begin() + std::ptrdiff_t(i));
    EXPECT_NE(errorOf(joined(without)), "") << i;
    std::vector<std::string> twice = lines;
    twice.insert(twice.begin() + std::ptrdiff_t(i), lines[i]);
    EXPECT_NE(errorOf(joined(twice)), "") << i;
    std::vector<std::string> swapped = lines;
    std::swap(swapped[i], swapped[(i + 1) % lines.size()]);
    EXPECT_NE(errorOf(joined(swapped)), "") << i;
  }
}

/// A recording of this frame with a right checksum: what a wrong writer would make.
std::string forged(const std::string& frame) {
  std::string text;
  std::uint64_t checksum = 0;
  for (const std::string& line :
       {std::string("terrane recording 1\n"), std::string("frames\n"), frame + "\n", std::string("end 1 ")}) {
    text += line;
    checksum = teHashBytes(line.data(), line.size(), checksum);
  }
  return text + teHexText(checksum) + "\n";
}

TEST_F(TeReplayTest, NoFrameIsTakenThatMakesNoSense) {
  m_test.settings.clear();
  EXPECT_EQ(errorOf(forged("0.5 #0123456789abcdef +A")), "");
  for (const char* frame : {"", "x", "nan", "inf", "-1", "1e999", "0.5s", " 0.5", "0.5  ", "0.5 A", "0.5 +",
                            "0.5 +a", "0.5 +A/", "0.5 +A/x", "0.5 +A/cs", "0.5 +A/ss", "0.5 #123",
                            "0.5 #0123456789ABCDEF", "0.5 +A #0123456789abcdef"})
    EXPECT_THAT(errorOf(forged(frame)), StartsWith("3: the file is damaged: ")) << frame;
  std::string many = "0.5";
  for (std::size_t i = 0; i <= TeRecordingFormat::kMaxKeys; ++i)
    many += " +A";
  EXPECT_THAT(errorOf(forged(many)), HasSubstr("more than 1000 keys"));
}

} // namespace
