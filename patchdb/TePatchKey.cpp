#include "patchdb/TePatchKey.h"

glm::ivec2 teStep(TeDirection direction) {
  static const glm::ivec2 steps[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  return steps[int(direction)];
}
