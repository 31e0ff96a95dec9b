#pragma once

#include "patchdb/TeTestWorlds.h"

/// Terrain with a sample every metre, in patches of 16 m, of which those are known that were built.
inline std::unique_ptr<TePatchDatabase> teTestGround(TeSampleSource::Function height) {
  return teSampleWorld(std::move(height), 33);
}

inline std::unique_ptr<TePatchDatabase> teNoGround() {
  return teTestGround([](std::int64_t, std::int64_t) { return 0.0f; });
}

/// Makes the patches with keys -radius .. radius known, 16 m each.
inline void teBuildAround(TePatchDatabase& terrain, int radius) {
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x)
      (void)*terrain.build({x, y});
}
