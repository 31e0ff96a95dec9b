#pragma once

#include <cstdio>
#include <string>

/// Reads "LOWEST/LEVELS", as 16/3: the lowest resolution of a patch and the number of resolutions.
inline bool teReadLayout(const std::string& text, int& minResolution, int& levels) {
  int used = 0;
  return std::sscanf(text.c_str(), "%d/%d%n", &minResolution, &levels, &used) == 2 &&
         std::size_t(used) == text.size();
}

/// For options.
inline std::string teCheckLayout(std::string& text) {
  int minResolution = 0, levels = 0;
  return teReadLayout(text, minResolution, levels)
             ? std::string()
             : "must be LOWEST/LEVELS, such as 16/3, not '" + text + "'";
}
