#pragma once

#include "generators/TeSourceChooser.h"
#include "patchdb/TeSourceMap.h"

#include <cstddef>
#include <unordered_map>

/// All source maps, each in memory once: four patches share a map, and it is freed with the last pointer to
/// it. For each key the store remembers for ever which source its map is made with, so that a map that was
/// dropped comes back the same after the world's sources have changed: its borders with maps and patches made
/// before would tear otherwise. This costs about 70 bytes a key.
/// Not thread-safe except for concurrent const calls.
class TeMapStore {
public:
  /// The source of a map: the one remembered, or the chooser's, remembered from now on. Error: the chooser
  /// has none.
  TeResult<TeHeightSourcePtr> source(TeMapKey key, const TeSourceChooser& chooser);
  /// The source remembered for a key; null if there is none.
  TeHeightSourcePtr source(TeMapKey key) const;

  /// The map if it is in memory, else null.
  TeSourceMapPtr find(TeMapKey key) const;
  /// Stores a finished map, or finds the one that someone else has finished meanwhile. Its source must be
  /// remembered.
  TeSourceMapPtr add(TeMapKey key, TeHeightMap heights);

  /// Maps in memory, and the bytes of their heights.
  std::size_t residentMaps() const;
  std::size_t residentBytes() const;

private:
  struct KeyHash {
    std::size_t operator()(const TeMapKey& key) const;
  };
  struct Entry {
    TeHeightSourcePtr source;
    std::weak_ptr<const TeSourceMap> map;
  };
  std::unordered_map<TeMapKey, Entry, KeyHash> m_entries;
};
