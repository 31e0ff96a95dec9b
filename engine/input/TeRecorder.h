#pragma once

#include "engine/input/TeRecordingFormat.h"

#include <cstdio>
#include <memory>
#include <string>

/// Writes what happens in a run to a file (TeRecordingFormat), for TeReplay.
///
/// The text goes to a file of its own beside the target, "TARGET.part", which takes the target's place when
/// the recording is finished; so the target is never half a recording. Without finish() nothing is left.
class TeRecorder {
public:
  using Settings = TeRecordingFormat::Settings;

  /// `settings`: all that the run depends on besides its keys and times; a replay must have the same. Error,
  /// naming the file: it cannot be written there, or it is no plain file; a setting that cannot be written.
  static TeResult<std::unique_ptr<TeRecorder>> create(const std::string& file, const Settings& settings);
  ~TeRecorder();
  TeRecorder(const TeRecorder&) = delete;
  TeRecorder& operator=(const TeRecorder&) = delete;

  /// What cannot be written is reported by finish(): the run goes on. Cost: less than a microsecond and 20
  /// bytes of file.
  void add(const TeRecordedFrame& frame);
  std::size_t frames() const { return m_frames; }
  /// Writes the end and puts the file in its place; once, nothing can be added any more. Error, and no file:
  /// the first thing that could not be written.
  TeStatus finish();

private:
  explicit TeRecorder(std::string file);
  void write(const std::string& text);
  void fail(const std::string& reason);

  std::string m_file;
  std::string m_part;
  std::FILE* m_stream = nullptr; ///< null once finished
  std::uint64_t m_checksum = 0;
  std::size_t m_frames = 0;
  std::size_t m_bytes = 0;
  std::string m_error;
};
