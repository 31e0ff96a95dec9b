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
  friend bool operator==(const TePatchBlock& a, const TePatchBlock& b) {
    return a.centre == b.centre && a.radius == b.radius;
  }
};
