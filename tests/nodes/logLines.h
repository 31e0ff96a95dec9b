#pragma once

#include "generators/base/TeLog.h"

#include <string>
#include <vector>

/// Lines of TeLog for as long as it lives.
class LogLines {
public:
  LogLines() {
    TeLog::setSink([this](TeLog::Level, const std::string& line) { lines.push_back(line); });
  }
  ~LogLines() { TeLog::setSink({}); }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;
  std::vector<std::string> lines;
};
