#pragma once

#include "engine/input/TeReplay.h"

#include <string_view>

/// Reads one recording's text.
class TeReplayReader {
public:
  TeReplayReader(std::string file, std::string_view text) : m_file(std::move(file)), m_rest(text) {}
  TeResult<TeReplay> read(const TeReplay::Settings& settings);

private:
  TeStatus readHeader();
  TeResult<TeReplay::Settings> readSettings();
  TeStatus readFrames(std::vector<TeRecordedFrame>& frames);
  TeStatus readEnd(std::string_view line, std::size_t frames) const;
  /// The next line without its end, false if there is none that is whole.
  bool nextLine(std::string_view& line);
  TeError error(const std::string& reason) const;
  TeError cutOff() const;

  std::string m_file;
  std::string_view m_rest;
  std::size_t m_line = 0;             ///< of the line read last, from 1
  std::uint64_t m_checksum = 0;       ///< of all lines read
  std::uint64_t m_checksumBefore = 0; ///< without the last
};
