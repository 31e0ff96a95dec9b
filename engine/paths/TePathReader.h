#pragma once

#include "engine/paths/TePath.h"

/// Reads one path from text (TePath describes the format).
class TePathReader {
public:
  explicit TePathReader(std::string name) : m_name(std::move(name)) {}
  TeResult<TePath> read(std::string_view text);

private:
  TeStatus readLine(std::string_view line);
  TeStatus readPoint(const std::vector<std::string_view>& words, bool jump);
  TeError error(const std::string& reason) const;

  std::string m_name;
  std::size_t m_line = 0;
  std::vector<TePathPoint> m_points;
  bool m_repeats = false;
};
