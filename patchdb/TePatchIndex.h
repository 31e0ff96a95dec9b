#pragma once

#include "patchdb/TePatchKey.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class TePatchData;

/// Finds the patches of one level by the x and y of their keys in a time that does not grow with their
/// number: a hash table with open addressing, at most half full, beside the tree that owns them.
///
/// Memory: 32 to 64 bytes a patch.
class TePatchIndex {
public:
  std::size_t size() const { return m_size; }
  std::size_t bytes() const { return m_slots.capacity() * sizeof(Slot); }

  /// Null if it is not there.
  TePatchData* find(std::int64_t x, std::int64_t y) const;
  /// Room for so many: until then add() needs no memory. If memory runs out it throws and is as before.
  void reserve(std::size_t patches);
  /// A patch whose key is not there yet; there must be room.
  void add(TePatchData& patch);
  /// A patch that is there.
  void remove(const TePatchData& patch);

private:
  struct Slot {
    std::uint64_t hash = 0;
    TePatchData* patch = nullptr; ///< null: free
  };

  static std::uint64_t hashOf(std::int64_t x, std::int64_t y) {
    return std::uint64_t(x) * 0x9e3779b97f4a7c15u + std::uint64_t(y) * 0xc2b2ae3d27d4eb4fu;
  }
  /// Where a patch is to be, if others do not fill the place.
  std::size_t home(std::uint64_t hash) const { return std::size_t(hash >> m_shift); }

  std::vector<Slot> m_slots; ///< 0 or a power of two
  std::size_t m_size = 0;
  int m_shift = 0; ///< 64 less the logarithm of the number of slots
};
