#pragma once

#include "patchdb/TeGrowingTree.h"
#include "patchdb/TePatchData.h"

/// What a look-up does where the patch is not known.
enum class TeLookup { Create, NearestCoarser, Null };

/// All patch records by key: one growing quadtree a level, since the trees' alignment differs from that of
/// keys. Keeps the pointers between neighbours right, both ways, as records come and go.
/// A record keeps its address until it is removed. Not thread-safe except for concurrent const calls.
class TePatchTree {
public:
  /// Null if not known. The cost does not grow with the number of patches.
  TePatchData* find(const TePatchKey& key) const { return level(key.level).find(key.x, key.y); }
  /// By strategy: the record, made if there is none; or that of the nearest known ancestor (the patch itself
  /// first), null if there is none; or null. Error: the key is not valid.
  TeResult<TePatchData*> lookup(const TePatchKey& key, TeLookup strategy);
  /// The record of the patch or its nearest known ancestor that has heights; null if there is none.
  TePatchData* nearestWithHeights(const TePatchKey& key) const;
  /// False if it was not known.
  bool remove(const TePatchKey& key);

  std::size_t size() const;
  std::size_t bytes() const;
  /// The tree of a level; empty if nothing of that level is stored.
  const TeGrowingTree& level(int level) const {
    return level >= 0 && level < int(m_levels.size()) ? m_levels[std::size_t(level)] : m_noLevel;
  }
  const TeGrowingTree& base() const { return m_levels.empty() ? m_noLevel : m_levels.front(); }

private:
  TePatchData& create(const TePatchKey& key);

  std::vector<TeGrowingTree> m_levels;
  TeGrowingTree m_noLevel;
};
