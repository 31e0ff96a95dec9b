#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

/// A priority queue of triangles that is kept from frame to frame: a heap with four children an entry, in one
/// array, and where each triangle is in it.
///
/// The order is whole: of equal priorities the triangle with the lower number is the more important one. So
/// it does not depend on the order of insertion. A queue of splits has the most important triangle at its
/// top, one of merges the least important.
///
/// Heaps beat buckets here: from one frame to the next nearly all entries stay where they are, so refresh()
/// is a pass over the array that moves few, about 3 ns an entry; and priorities may be any number.
class TeRoamQueue {
public:
  enum class Order { MostImportantFirst, LeastImportantFirst };
  explicit TeRoamQueue(Order order)
      : m_inverted(order == Order::LeastImportantFirst ? ~std::uint64_t(0) : 0) {}

  bool empty() const { return m_entries.empty(); }
  std::size_t size() const { return m_entries.size(); }
  std::size_t bytes() const {
    return m_entries.capacity() * sizeof(Entry) + m_places.capacity() * sizeof(std::int32_t);
  }
  std::int32_t top() const { return m_entries.front().node; }
  float topPriority() const { return priorityOf(m_entries.front()); }
  bool contains(std::int32_t node) const {
    return std::size_t(node) < m_places.size() && m_places[std::size_t(node)] >= 0;
  }

  void clear();
  /// Priorities are not NaN; below 0 counts as 0. The node is not in the queue.
  void insert(std::int32_t node, std::uint32_t number, float priority);
  void remove(std::int32_t node); ///< one that is in the queue
  /// All priorities anew: entry i of `priorities` is that of node i.
  void refresh(const float* priorities);

  /// Every entry knows its place, and is not before its parent in the heap; for tests.
  bool isConsistent() const;

private:
  struct Entry {
    std::uint64_t order = 0; ///< the largest is at the top
    std::int32_t node = 0;
  };

  /// Numbers of one sign are ordered as their bits are.
  static std::uint64_t bitsOf(float priority) {
    const float clamped = priority > 0 ? priority : 0.0f;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &clamped, sizeof bits);
    return bits;
  }
  std::uint64_t orderOf(std::uint32_t number, float priority) const {
    return (bitsOf(priority) << 32 | std::uint32_t(~number)) ^ m_inverted;
  }
  float priorityOf(const Entry& entry) const;
  void put(std::size_t place, const Entry& entry) {
    m_entries[place] = entry;
    m_places[std::size_t(entry.node)] = std::int32_t(place);
  }
  void siftUp(std::size_t place, Entry entry);
  void siftDown(std::size_t place, Entry entry);

  std::uint64_t m_inverted;
  std::vector<Entry> m_entries;
  std::vector<std::int32_t> m_places; ///< by node; negative: not here
};
