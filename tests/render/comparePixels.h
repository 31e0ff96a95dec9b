#pragma once

#include "nodes/TePicture.h"

#include <algorithm>
#include <cstdlib>

/// How two pictures of one size differ.
struct TePixelDifference {
  int pixels = 0;  ///< that differ at all
  int largest = 0; ///< difference of a channel
};

inline TePixelDifference comparePixels(const TePicture& a, const TePicture& b) {
  TePixelDifference difference;
  if (a.rgba.size() != b.rgba.size())
    return {-1, 255};
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t channel = pixel; channel < pixel + 4; channel++)
      largest = std::max(largest, std::abs(int(a.rgba[channel]) - int(b.rgba[channel])));
    difference.pixels += largest > 0;
    difference.largest = std::max(difference.largest, largest);
  }
  return difference;
}
