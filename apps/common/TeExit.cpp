#include "apps/common/TeExit.h"

#include <algorithm>
#include <cstdio>

int teExitWith(TeExit status, const std::string& application, const std::string& message) {
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::fprintf(stderr, "%s: %s\n", application.c_str(), line.c_str());
  return status;
}
