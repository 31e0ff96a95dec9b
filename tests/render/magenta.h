#pragma once

#include "nodes/TePicture.h"

#include <vector>

/// The background that draw() gives pictures if nothing else is said.
constexpr TePicture::Pixel kMagenta = {255, 0, 255, 255};

/// Background pixels that no path over background connects with the picture's rim.
inline int enclosedBackground(const TePicture& picture) {
  const int width = picture.width;
  const int height = picture.height;
  std::vector<char> reached(std::size_t(width) * height, 0);
  std::vector<int> open;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= width || y >= height || reached[std::size_t(y) * width + x] ||
        picture.pixel(x, y) != kMagenta)
      return;
    reached[std::size_t(y) * width + x] = 1;
    open.push_back(y * width + x);
  };
  for (int x = 0; x < width; x++) {
    visit(x, 0);
    visit(x, height - 1);
  }
  for (int y = 0; y < height; y++) {
    visit(0, y);
    visit(width - 1, y);
  }
  while (!open.empty()) {
    const int x = open.back() % width;
    const int y = open.back() / width;
    open.pop_back();
    visit(x - 1, y);
    visit(x + 1, y);
    visit(x, y - 1);
    visit(x, y + 1);
  }
  int enclosed = 0;
  for (int y = 0; y < height; y++) {
    for (int x = 0; x < width; x++)
      enclosed += picture.pixel(x, y) == kMagenta && !reached[std::size_t(y) * width + x];
  }
  return enclosed;
}

inline int countMagenta(const TePicture& picture) {
  int count = 0;
  for (int y = 0; y < picture.height; y++) {
    for (int x = 0; x < picture.width; x++)
      count += picture.pixel(x, y) == kMagenta;
  }
  return count;
}
