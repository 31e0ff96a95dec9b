#pragma once

#include "patchdb/TePatchKey.h"
#include "patchdb/TeSourceMap.h"

/// Key of the source map centred on a corner of the patch.
inline TeMapKey teMapKey(const TePatchKey& patch, int corner) {
  return {patch.x + corner % 2, patch.y + corner / 2};
}

/// Which maps a patch's heights are made from: all four, or, if the four have one source that fits, the one
/// whose key is even in x and y. It holds the patch whole, and four patches share it, so that land that fits
/// by itself costs a quarter of the maps; the heights have the bits that blending would give.
class TeNeededMaps {
public:
  TeNeededMaps() = default;
  TeNeededMaps(const TePatchKey& patch, const std::array<TeHeightSourcePtr, 4>& sources);
  bool operator[](int corner) const { return m_only < 0 || m_only == corner; }
  /// The one corner that is needed; -1 if all are.
  int only() const { return m_only; }

private:
  int m_only = -1;
};
