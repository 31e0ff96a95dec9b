#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// A set of pairs of whole numbers that are likely to lie near each other: 8×8 cells are one word of bits in
/// a hash table (open addressing, linear probing, at most 3/4 full). A full square of keys takes less than a
/// byte a key; a key far from all others up to 64 bytes.
/// Not thread-safe except for concurrent const calls.
class TeKeySet {
public:
  bool contains(std::int64_t x, std::int64_t y) const;
  /// True if it was new. O(1), but for the doubling of the table: 10 ns a square of 8×8 then. If memory runs
  /// out it throws and is as before.
  bool insert(std::int64_t x, std::int64_t y);
  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  std::size_t bytes() const { return m_squares.capacity() * sizeof(Square); }

private:
  struct Square {
    std::int64_t x = 0; ///< of its keys without the last three bits
    std::int64_t y = 0;
    std::uint64_t keys = 0; ///< a bit for each; 0 = the place is free
  };
  static std::uint64_t bitOf(std::int64_t x, std::int64_t y) {
    return std::uint64_t(1) << ((x & 7) + 8 * (y & 7));
  }
  /// Where the square is, or would be.
  static std::size_t find(const std::vector<Square>& squares, std::int64_t x, std::int64_t y);
  void grow();

  std::vector<Square> m_squares; ///< a power of two of them, or none
  std::size_t m_used = 0;
  std::size_t m_size = 0;
};
