#pragma once

#include "patchdb/TePatchData.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Finds the patches of one level by the x and y of their keys in a time that does not grow with their
/// number: a hash table beside the tree that owns them.
///
/// Its buckets are cache lines of four places, at most half of all places are taken, and a full bucket
/// continues in the next one. So nineteen of twenty patches are in the first bucket that is looked at, in
/// whichever place, and the processor foresees the way of a look-up.
/// Memory: 32 to 64 bytes a patch.
class TePatchIndex {
public:
  std::size_t size() const { return m_size; }
  std::size_t bytes() const { return m_buckets.capacity() * sizeof(Bucket); }

  /// Null if it is not there.
  TePatchData* find(std::int64_t x, std::int64_t y) const {
    if (m_buckets.empty())
      return nullptr;
    const std::uint64_t hash = hashOf(x, y);
    for (std::size_t i = home(hash);; i = (i + 1) & last()) {
      const Bucket& bucket = m_buckets[i];
      for (unsigned same = bucket.placesOf(hash); same != 0; same &= same - 1) {
        TePatchData* patch = bucket.patches[std::size_t(__builtin_ctz(same))];
        if (patch->key().x == x && patch->key().y == y)
          return patch;
      }
      if (!bucket.isFull())
        return nullptr;
    }
  }
  /// Room for so many: until then add() needs no memory. If memory runs out it throws and is as before.
  void reserve(std::size_t patches);
  /// A patch whose key is not there yet; there must be room.
  void add(TePatchData& patch);
  /// A patch that is there.
  void remove(const TePatchData& patch);

private:
  static constexpr std::size_t kPlaces = 4;

  /// Taken places come first.
  struct alignas(64) Bucket {
    std::array<std::uint64_t, kPlaces> hashes{}; ///< 0: free
    std::array<TePatchData*, kPlaces> patches{};

    bool isFull() const { return hashes[kPlaces - 1] != 0; }
    /// A bit for each place with a hash.
    unsigned placesOf(std::uint64_t hash) const {
      return unsigned(hashes[0] == hash) | unsigned(hashes[1] == hash) << 1 |
             unsigned(hashes[2] == hash) << 2 | unsigned(hashes[3] == hash) << 3;
    }
    std::size_t taken() const;
    /// Takes a patch out, and puts the last one in its place.
    void drop(std::size_t place);
  };

  /// Never 0.
  static std::uint64_t hashOf(std::int64_t x, std::int64_t y) {
    return (std::uint64_t(x) * 0x9e3779b97f4a7c15u + std::uint64_t(y) * 0xc2b2ae3d27d4eb4fu) | 1;
  }
  std::size_t last() const { return m_buckets.size() - 1; }
  /// The bucket of a hash, unless it is full.
  std::size_t home(std::uint64_t hash) const { return std::size_t(hash >> 1 >> m_shift); }

  std::vector<Bucket> m_buckets; ///< 0 or a power of two
  std::size_t m_size = 0;
  int m_shift = 63; ///< less the logarithm of the number of buckets
};
