#pragma once

#include <fstream>
#include <string>

/// Writes side² numbers, row·256 + column, rows from the north; of two bytes, or the lower one only.
inline void writeRaw(const std::string& path, int side, int bytes = 2) {
  std::ofstream file(path, std::ios::binary);
  for (int row = 0; row < side; row++) {
    for (int column = 0; column < side; column++) {
      const int value = row * 256 + column;
      file.put(char(value & 255));
      if (bytes == 2)
        file.put(char(value >> 8));
    }
  }
}
