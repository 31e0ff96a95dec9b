#include "nodes/clipmap/TePyramidFiles.h"

std::string tePyramidLevelFile(const std::string& name, int level) {
  return name + "_" + std::to_string(level) + ".raw";
}

int tePyramidLevelOfSide(long long side) {
  for (int level = 1; level <= kTeHighestPyramidLevel; ++level)
    if (tePyramidSide(level) == side)
      return level;
  return -1;
}
