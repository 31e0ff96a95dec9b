#include "nodes/lod/roam/TeRoamQueue.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace {

constexpr std::size_t kChildren = 4;

} // namespace

float TeRoamQueue::priorityOf(const Entry& entry) const {
  const auto bits = std::uint32_t((entry.order ^ m_inverted) >> 32);
  float priority = 0;
  std::memcpy(&priority, &bits, sizeof bits);
  return priority;
}

void TeRoamQueue::clear() {
  for (const Entry& entry : m_entries)
    m_places[std::size_t(entry.node)] = -1;
  m_entries.clear();
}

void TeRoamQueue::insert(std::int32_t node, std::uint32_t number, float priority) {
  assert(!contains(node));
  if (std::size_t(node) >= m_places.size())
    m_places.resize(std::size_t(node) + 1 + m_places.size() / 2, -1);
  m_entries.emplace_back();
  siftUp(m_entries.size() - 1, {orderOf(number, priority), node});
}

void TeRoamQueue::remove(std::int32_t node) {
  assert(contains(node));
  const auto place = std::size_t(m_places[std::size_t(node)]);
  m_places[std::size_t(node)] = -1;
  const Entry last = m_entries.back();
  m_entries.pop_back();
  if (place == m_entries.size())
    return;
  if (place > 0 && m_entries[(place - 1) / kChildren].order < last.order)
    siftUp(place, last);
  else
    siftDown(place, last);
}

void TeRoamQueue::refresh(const float* priorities) {
  constexpr std::uint64_t kLow = 0xffffffff;
  for (Entry& entry : m_entries)
    entry.order = (bitsOf(priorities[entry.node]) << 32 ^ (m_inverted & ~kLow)) | (entry.order & kLow);
  if (m_entries.size() < 2)
    return;
  for (std::size_t place = (m_entries.size() - 2) / kChildren + 1; place-- > 0;)
    siftDown(place, m_entries[place]);
}

void TeRoamQueue::siftUp(std::size_t place, Entry entry) {
  while (place > 0) {
    const std::size_t parent = (place - 1) / kChildren;
    if (m_entries[parent].order >= entry.order)
      break;
    put(place, m_entries[parent]);
    place = parent;
  }
  put(place, entry);
}

void TeRoamQueue::siftDown(std::size_t place, Entry entry) {
  const std::size_t start = place;
  for (;;) {
    const std::size_t first = kChildren * place + 1;
    if (first >= m_entries.size())
      break;
    const std::size_t end = std::min(first + kChildren, m_entries.size());
    std::uint64_t most = entry.order;
    std::size_t best = place;
    for (std::size_t child = first; child < end; child++) {
      best = m_entries[child].order > most ? child : best;
      most = std::max(most, m_entries[child].order);
    }
    if (best == place)
      break;
    put(place, m_entries[best]);
    place = best;
  }
  if (place != start || m_places[std::size_t(entry.node)] != std::int32_t(place))
    put(place, entry);
}

bool TeRoamQueue::isConsistent() const {
  std::size_t present = 0;
  for (const std::int32_t place : m_places)
    present += place >= 0;
  for (std::size_t place = 0; place < m_entries.size(); place++) {
    if (m_places[std::size_t(m_entries[place].node)] != std::int32_t(place))
      return false;
    if (place > 0 && m_entries[(place - 1) / kChildren].order < m_entries[place].order)
      return false;
  }
  return present == m_entries.size();
}
