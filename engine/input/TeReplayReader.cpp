#include "engine/input/TeReplayReader.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <string>

namespace {

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// What makes two runs differ; empty if nothing does.
std::string difference(const TeReplay::Settings& recorded, const TeReplay::Settings& present) {
  for (const auto& [name, value] : recorded) {
    const auto found = present.find(name);
    if (found == present.end())
      return "recorded with " + name + " " + teQuoted(value) + ", which this run does not have";
    if (found->second != value)
      return "recorded with " + name + " " + teQuoted(value) + ", but this run has " +
             teQuoted(found->second);
  }
  for (const auto& [name, value] : present)
    if (recorded.find(name) == recorded.end())
      return "recorded without " + name + ", but this run has " + teQuoted(value);
  return {};
}

} // namespace

TeError TeReplayReader::error(const std::string& reason) const {
  return {m_file + ":" + std::to_string(m_line) + ": " + reason};
}

TeError TeReplayReader::cutOff() const {
  return {m_file + ":" + std::to_string(m_line + 1) + ": the recording was cut off: its end is missing"};
}

bool TeReplayReader::nextLine(std::string_view& line) {
  const std::size_t end = m_rest.find('\n');
  if (end == std::string_view::npos)
    return false;
  line = m_rest.substr(0, end);
  ++m_line;
  m_checksumBefore = m_checksum;
  m_checksum = teHashBytes(m_rest.data(), end + 1, m_checksum);
  m_rest.remove_prefix(end + 1);
  return true;
}

TeResult<TeReplay> TeReplayReader::read(const TeReplay::Settings& settings) {
  if (const TeStatus header = readHeader(); !header)
    return header.error();
  const TeResult<TeReplay::Settings> recorded = readSettings();
  if (!recorded)
    return recorded.error();
  const std::size_t before = m_line;
  std::vector<TeRecordedFrame> frames;
  if (const TeStatus read = readFrames(frames); !read)
    return read.error();
  // Only now, when it is known that the text is what was written.
  if (const std::string differs = difference(*recorded, settings); !differs.empty())
    return TeError{m_file + ":2: " + differs};
  return TeReplay(m_file, before + 1, std::move(frames));
}

TeStatus TeReplayReader::readHeader() {
  const std::string expected =
      std::string(TeRecordingFormat::kMagic) + std::to_string(TeRecordingFormat::kVersion);
  std::string_view line;
  if (!nextLine(line)) {
    const bool beginning = std::string_view(expected).substr(0, m_rest.size()) == m_rest;
    return beginning ? cutOff() : TeError{m_file + ":1: this is not a recording of Terrane"};
  }
  if (!startsWith(line, TeRecordingFormat::kMagic))
    return error("this is not a recording of Terrane");
  if (line != expected)
    return error("a recording of version " + teQuoted(line.substr(TeRecordingFormat::kMagic.size())) +
                 "; this program reads version " + std::to_string(TeRecordingFormat::kVersion));
  return {};
}

TeResult<TeReplay::Settings> TeReplayReader::readSettings() {
  TeReplay::Settings settings;
  std::string_view line;
  while (nextLine(line)) {
    if (line == TeRecordingFormat::kFrames)
      return settings;
    if (!startsWith(line, TeRecordingFormat::kSetting))
      return error("the file is damaged: neither a setting nor \"" + std::string(TeRecordingFormat::kFrames) +
                   "\": " + teQuoted(line));
    const std::string_view setting = line.substr(TeRecordingFormat::kSetting.size());
    const std::size_t space = setting.find(' ');
    if (space == std::string_view::npos)
      return error("the file is damaged: a setting without a value");
    settings.emplace(setting.substr(0, space), setting.substr(space + 1));
  }
  return cutOff();
}

TeStatus TeReplayReader::readFrames(std::vector<TeRecordedFrame>& frames) {
  std::string_view line;
  while (nextLine(line)) {
    if (startsWith(line, TeRecordingFormat::kEnd))
      return readEnd(line, frames.size());
    if (frames.size() == TeRecordingFormat::kMaxFrames)
      return error("more than " + std::to_string(TeRecordingFormat::kMaxFrames) + " frames");
    TeResult<TeRecordedFrame> frame = TeRecordingFormat::parseFrame(line);
    if (!frame)
      return error("the file is damaged: " + frame.error().message);
    frames.push_back(std::move(*frame));
  }
  return cutOff();
}

TeStatus TeReplayReader::readEnd(std::string_view line, std::size_t frames) const {
  const std::string before = std::string(TeRecordingFormat::kEnd) + std::to_string(frames) + " ";
  if (!startsWith(line, before))
    return error("the file is damaged: it has " + std::to_string(frames) + " frames, but its end says " +
                 teQuoted(line));
  const std::uint64_t checksum = teHashBytes(before.data(), before.size(), m_checksumBefore);
  if (TeRecordingFormat::parseHash(line.substr(before.size())) != checksum)
    return error("the file is damaged: its checksum differs from what the end says");
  if (!m_rest.empty())
    return error("the file is damaged: something follows its end");
  return {};
}
