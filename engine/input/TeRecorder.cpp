#include "engine/input/TeRecorder.h"

#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

TeRecorder::TeRecorder(std::string file) : m_file(std::move(file)), m_part(m_file + ".part") {}

TeResult<std::unique_ptr<TeRecorder>> TeRecorder::create(const std::string& file, const Settings& settings) {
  if (file.empty())
    return TeError{"TeRecorder: cannot be written: no file was named"};
  for (const auto& [name, value] : settings)
    if (const std::string fault = TeRecordingFormat::settingFault(name, value); !fault.empty())
      return TeError{file + ": cannot be recorded: " + fault};
  std::error_code error;
  if (const fs::file_status status = fs::status(file, error);
      fs::exists(status) && !fs::is_regular_file(status))
    return TeError{file + ": cannot be written: it is not a plain file"};
  std::unique_ptr<TeRecorder> recorder(new TeRecorder(file));
  recorder->m_stream = std::fopen(recorder->m_part.c_str(), "wb");
  if (!recorder->m_stream)
    return TeError{file + ": cannot be written: " + std::strerror(errno)};
  recorder->write(std::string(TeRecordingFormat::kMagic) + std::to_string(TeRecordingFormat::kVersion) +
                  "\n");
  for (const auto& [name, value] : settings)
    recorder->write(TeRecordingFormat::settingLine(name, value) + "\n");
  recorder->write(std::string(TeRecordingFormat::kFrames) + "\n");
  return recorder;
}

TeRecorder::~TeRecorder() {
  if (!m_stream)
    return;
  std::fclose(m_stream);
  std::remove(m_part.c_str());
}

void TeRecorder::fail(const std::string& reason) {
  if (m_error.empty())
    m_error = m_file + ": cannot be written: " + reason;
}

void TeRecorder::write(const std::string& text) {
  if (!m_stream || !m_error.empty())
    return;
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), m_stream) != text.size())
    fail(std::strerror(errno));
  m_checksum = teHashBytes(text.data(), text.size(), m_checksum);
  m_bytes += text.size();
}

void TeRecorder::add(const TeRecordedFrame& frame) {
  if (!std::isfinite(frame.dt) || frame.dt < 0)
    fail("a frame's time must be finite and not negative");
  else if (m_frames == TeRecordingFormat::kMaxFrames)
    fail("more than " + std::to_string(TeRecordingFormat::kMaxFrames) + " frames");
  else if (frame.keys.size() > TeRecordingFormat::kMaxKeys)
    fail("more than " + std::to_string(TeRecordingFormat::kMaxKeys) + " keys in a frame");
  if (!m_error.empty())
    return;
  const std::string line = TeRecordingFormat::frameLine(frame) + "\n";
  // Room for the end line, so that what is written can be read.
  if (m_bytes + line.size() + 100 > TeRecordingFormat::kMaxBytes) {
    fail("more than " + std::to_string(TeRecordingFormat::kMaxBytes) + " bytes");
    return;
  }
  write(line);
  ++m_frames;
}

TeStatus TeRecorder::finish() {
  if (!m_stream)
    return TeError{m_file + ": the recording is finished already"};
  write(std::string(TeRecordingFormat::kEnd) + std::to_string(m_frames) + " ");
  write(teHexText(m_checksum) + "\n");
  errno = 0;
  if (std::fclose(std::exchange(m_stream, nullptr)) != 0)
    fail(std::strerror(errno));
  if (m_error.empty() && std::rename(m_part.c_str(), m_file.c_str()) != 0)
    fail(std::strerror(errno));
  if (m_error.empty())
    return {};
  std::remove(m_part.c_str());
  return TeError{m_error};
}
