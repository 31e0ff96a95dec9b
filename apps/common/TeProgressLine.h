#pragma once

#include <chrono>
#include <string>

/// Shows on standard error how far long work has come: a bar on a terminal, else a line now and then; nothing
/// for work that ends within half a second, or when quiet.
class TeProgressLine {
public:
  TeProgressLine(std::string what, bool quiet);
  ~TeProgressLine();
  TeProgressLine(const TeProgressLine&) = delete;
  TeProgressLine& operator=(const TeProgressLine&) = delete;

  /// fraction: 0 .. 1.
  void update(double fraction);

private:
  using Clock = std::chrono::steady_clock;

  std::string m_what;
  bool m_terminal;
  bool m_quiet;
  bool m_shown = false;
  Clock::time_point m_next;
};
