#include "engine/input/TeReplay.h"

#include "engine/input/TeReplayReader.h"
#include "generators/base/TeText.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace {

TeResult<std::string> textOf(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return TeError{file + ": cannot be read: it is not a plain file"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return TeError{file + ": cannot be read: " + std::strerror(errno)};
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error || bytes > TeRecordingFormat::kMaxBytes)
    return TeError{
        file + ": cannot be read: " +
        (error ? error.message() : "larger than any recording, " + std::to_string(bytes) + " bytes")};
  std::string text(std::size_t(bytes), '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  if (std::size_t(stream.gcount()) != text.size())
    return TeError{file + ": cannot be read to its end"};
  return text;
}

} // namespace

TeResult<TeReplay> TeReplay::read(const std::string& file, const Settings& settings) {
  const TeResult<std::string> text = textOf(file);
  return text ? TeReplayReader(file, *text).read(settings) : text.error();
}

TeStatus TeReplay::compare(std::size_t frame, std::uint64_t stateHash) const {
  if (frame >= m_frames.size())
    return TeError{m_file + ": the run goes on after the recording's " + std::to_string(m_frames.size()) +
                   " frames"};
  const std::optional<std::uint64_t>& recorded = m_frames[frame].stateHash;
  if (!recorded || *recorded == stateHash)
    return {};
  return TeError{m_file + ":" + std::to_string(m_firstLine + frame) +
                 ": the run differs from the recording in frame " + std::to_string(frame) + ": state " +
                 teHexText(stateHash) + ", recorded " + teHexText(*recorded)};
}
