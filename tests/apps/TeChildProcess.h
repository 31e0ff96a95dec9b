#pragma once

#include <string>
#include <vector>

/// What a program did.
struct TeChildResult {
  int status = -1; ///< exit status; 128 + signal if it was killed
  std::string output;
  std::string error;

  int errorLines() const;
};

/// Runs a program to its end; after `seconds` it is killed. Environment: as here, with "NAME=VALUE" of `with`
/// added and the names in `without` removed.
TeChildResult teRunChild(const std::vector<std::string>& command, double seconds = 60,
                         const std::vector<std::string>& with = {},
                         const std::vector<std::string>& without = {});
