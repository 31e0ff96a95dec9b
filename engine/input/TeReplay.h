#pragma once

#include "engine/input/TeRecordingFormat.h"

#include <string>
#include <vector>

/// A recording that was read, to be repeated.
class TeReplay {
public:
  using Settings = TeRecordingFormat::Settings;

  /// Reads and checks all of it. `settings`: those of this run, which must be the recording's. Error,
  /// "FILE:LINE: reason": it cannot be read, is no recording or one of another version, was cut off or
  /// changed, or was recorded with other settings. At most TeRecordingFormat::kMaxBytes are read.
  static TeResult<TeReplay> read(const std::string& file, const Settings& settings);

  const std::vector<TeRecordedFrame>& frames() const { return m_frames; }
  /// Whether the run is still the recorded one. Error: frame i has another state hash, or is beyond the end.
  /// A frame that was recorded without a hash agrees with any.
  TeStatus compare(std::size_t frame, std::uint64_t stateHash) const;

private:
  friend class TeReplayReader;
  TeReplay(std::string file, std::size_t firstLine, std::vector<TeRecordedFrame> frames)
      : m_file(std::move(file)), m_firstLine(firstLine), m_frames(std::move(frames)) {}

  std::string m_file;
  std::size_t m_firstLine; ///< of frame 0, counted from 1
  std::vector<TeRecordedFrame> m_frames;
};
