#pragma once

#include <functional>

/// What became of a piece of work in a process of its own.
struct TeChildRun {
  int status = -1; ///< what the work returned (0 .. 100), or -1 if it ended otherwise
  int signal = 0;  ///< that ended it; SIGKILL when it took too long
  double seconds = 0;
  long peakKilobytes = 0; ///< resident

  /// Forks, runs the work and waits for it, at most `limit` seconds.
  static TeChildRun of(const std::function<int()>& work, double limit);
};
