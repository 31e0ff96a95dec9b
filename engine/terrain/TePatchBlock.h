#pragma once

#include "patchdb/TePatchKey.h"

#include <cstdlib>

/// A square of (2r + 1)² base patches around one of them; at the rim of the world, those that exist.
struct TePatchBlock {
  TePatchKey centre;
  int radius = 1;

  bool contains(const TePatchKey& key) const {
    return key.level == 0 && std::llabs(key.x - centre.x) <= radius && std::llabs(key.y - centre.y) <= radius;
  }
  /// visit(key), rows from the south.
  template <class Visit> void forEach(const Visit& visit) const {
    for (std::int64_t y = centre.y - radius; y <= centre.y + radius; ++y)
      for (std::int64_t x = centre.x - radius; x <= centre.x + radius; ++x)
        if (const TePatchKey key{x, y, 0}; key.valid())
          visit(key);
  }
  /// The same for what is not in another block of the same radius.
  template <class Visit> void forEachBeyond(const TePatchBlock& other, const Visit& visit) const {
    const auto row = [&](std::int64_t y, std::int64_t from, std::int64_t to) {
      for (std::int64_t x = from; x <= to; ++x)
        if (const TePatchKey key{x, y, 0}; key.valid())
          visit(key);
    };
    const std::int64_t west = centre.x - radius;
    const std::int64_t east = centre.x + radius;
    for (std::int64_t y = centre.y - radius; y <= centre.y + radius; ++y) {
      if (y < other.centre.y - radius || y > other.centre.y + radius || other.centre.x - radius > east ||
          other.centre.x + radius < west) {
        row(y, west, east);
        continue;
      }
      row(y, west, other.centre.x - radius - 1);
      row(y, other.centre.x + radius + 1, east);
    }
  }
  friend bool operator==(const TePatchBlock& a, const TePatchBlock& b) {
    return a.centre == b.centre && a.radius == b.radius;
  }
};
