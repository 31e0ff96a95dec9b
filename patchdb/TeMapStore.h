#pragma once

#include "generators/TeSourceChooser.h"
#include "patchdb/TeKeySet.h"
#include "patchdb/TeSourceMap.h"

#include <cstddef>
#include <vector>

class TeResidentMaps;

/// All source maps, each in memory once: four patches share a map, and it is freed with the last pointer to
/// it. For each key the store remembers for ever which source its map is made with, so that a map that was
/// dropped comes back the same after the world's sources have changed: its borders with maps and patches made
/// before would tear otherwise.
///
/// What is remembered is the key alone, with the chooser of its time, which is asked again: see TeKeySet for
/// the few bytes a key. Finding the source costs O(choosers that maps were begun with).
/// Not thread-safe except for concurrent const calls; the last pointer to a map may go in any thread, and
/// after the store.
class TeMapStore {
public:
  explicit TeMapStore(std::shared_ptr<const TeSourceChooser> chooser);
  ~TeMapStore();
  TeMapStore(const TeMapStore&) = delete;
  TeMapStore& operator=(const TeMapStore&) = delete;

  /// For maps that are begun from now on.
  void setChooser(std::shared_ptr<const TeSourceChooser> chooser);

  /// The source of a map: of the chooser that it was begun with, from now on the present one. Error: the
  /// chooser has none.
  TeResult<TeHeightSourcePtr> begin(TeMapKey key);
  /// The source that a map was begun with; null if it was not.
  TeHeightSourcePtr source(TeMapKey key) const;

  /// The map if it is in memory, else null.
  TeSourceMapPtr find(TeMapKey key) const;
  /// Stores a finished map that was begun, or finds the one that someone else has finished meanwhile.
  TeSourceMapPtr add(TeMapKey key, TeHeightMap heights);

  /// Maps in memory, and the bytes of their heights; O(1).
  std::size_t residentMaps() const;
  std::size_t residentBytes() const;
  /// Keys that were begun, and the bytes that remembering them takes; O(choosers).
  std::size_t begunMaps() const;
  std::size_t recordBytes() const;

private:
  /// The time of one chooser.
  struct Epoch {
    std::shared_ptr<const TeSourceChooser> chooser;
    TeKeySet begun;
  };
  const Epoch* epochOf(TeMapKey key) const;

  std::vector<Epoch> m_epochs; ///< the present one is the last
  std::shared_ptr<TeResidentMaps> m_resident;
};
