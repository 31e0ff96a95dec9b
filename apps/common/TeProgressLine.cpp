#include "apps/common/TeProgressLine.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

using namespace std::chrono_literals;

TeProgressLine::TeProgressLine(std::string what, bool quiet)
    : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO)), m_quiet(quiet),
      m_next(Clock::now() + 500ms) {}

TeProgressLine::~TeProgressLine() {
  if (m_shown && m_terminal)
    std::fprintf(stderr, "\r\033[K");
}

void TeProgressLine::update(double fraction) {
  if (m_quiet || Clock::now() < m_next)
    return;
  const int percent = int(100 * std::clamp(fraction, 0.0, 1.0));
  if (m_terminal) {
    const std::string bar = std::string(std::size_t(percent) * 40 / 100, '#');
    std::fprintf(stderr, "\r%s [%-40s] %3d %%", m_what.c_str(), bar.c_str(), percent);
  } else {
    std::fprintf(stderr, "%s: %d %%\n", m_what.c_str(), percent);
  }
  std::fflush(stderr);
  m_shown = true;
  m_next = Clock::now() + (m_terminal ? 100ms : 2000ms);
}
