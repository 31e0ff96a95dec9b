#include "apps/TeViewInputs.h"

#include <algorithm>
#include <cmath>
#include <fstream>

double TeViewInputs::hills(double x, double y) {
  return 60 + 40 * std::sin(9 * x + 1) * std::cos(7 * y) + 12 * std::sin(31 * x - 23 * y) + 80 * x * y;
}

void TeViewInputs::writeGrid(const std::string& path, int samples, double step, const Height& height) {
  std::ofstream stream(path);
  stream << "ncols " << samples << "\nnrows " << samples << "\nxllcenter 0\nyllcenter 0\ncellsize " << step
         << "\nNODATA_value -9999\n";
  for (int y = samples - 1; y >= 0; --y) {
    for (int x = 0; x < samples; ++x) {
      const double h = height(double(x) / (samples - 1), double(y) / (samples - 1));
      stream << (std::isnan(h) ? -9999.0 : h) << ' ';
    }
    stream << '\n';
  }
}

void TeViewInputs::writePyramid(const std::string& name, int top, double unit, const Height& height) {
  for (int level = 0; level <= top; ++level) {
    const int cells = 1 << level;
    std::ofstream stream(name + "_" + std::to_string(level) + ".raw", std::ios::binary);
    for (int y = cells; y >= 0; --y)
      for (int x = 0; x <= cells; ++x) {
        const double steps = std::round(height(double(x) / cells, double(y) / cells) / unit);
        const int value = int(std::clamp(steps, 0.0, 65535.0));
        stream.put(char(value & 255)).put(char(value >> 8));
      }
  }
}
