#include "patchdb/TeNeededMaps.h"

TeNeededMaps::TeNeededMaps(const TePatchKey& patch, const std::array<TeHeightSourcePtr, 4>& sources) {
  for (const TeHeightSourcePtr& source : sources)
    if (!source->fits() || source->fingerprint() != sources[0]->fingerprint())
      return;
  for (int corner = 0; corner < 4; ++corner) {
    const TeMapKey key = teMapKey(patch, corner);
    if (key.x % 2 == 0 && key.y % 2 == 0)
      m_only = corner;
  }
}
