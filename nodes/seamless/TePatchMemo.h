#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// Remembers a number for each patch that was asked for during one selection: an open hash table that is
/// emptied at no cost. Memory: 24 bytes for each two patches of the largest selection.
class TePatchMemo {
public:
  /// Forgets all.
  void clear();

  /// The number of a patch (level up to 31, x and y below 2^29), made by `make()` when first asked for.
  template <class Make> double get(int level, std::int32_t x, std::int32_t y, const Make& make) {
    const std::uint64_t key = std::uint64_t(level) << 58 | std::uint64_t(y) << 29 | std::uint64_t(x);
    std::size_t slot = find(key);
    if (m_slots[slot].round != m_round) {
      const double number = make();
      slot = insert(key, number);
    }
    return m_slots[slot].number;
  }

private:
  struct Slot {
    std::uint64_t key = 0;
    double number = 0;
    std::uint32_t round = 0; ///< empty if not m_round
  };
  std::size_t find(std::uint64_t key) const;
  std::size_t insert(std::uint64_t key, double number);

  std::vector<Slot> m_slots = std::vector<Slot>(1024);
  std::size_t m_used = 0;
  std::uint32_t m_round = 1;
};
