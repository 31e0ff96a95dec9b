#pragma once

#include <string>

/// How an application ends.
enum TeExit {
  TeExitSuccess = 0,
  TeExitFailure = 1, ///< the work failed
  TeExitUsage = 2,   ///< bad usage or bad input
};

/// Prints one line `application: message` on standard error and returns the status.
int teExitWith(TeExit status, const std::string& application, const std::string& message);
