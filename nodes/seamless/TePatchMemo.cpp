#include "nodes/seamless/TePatchMemo.h"

void TePatchMemo::clear() {
  m_used = 0;
  if (++m_round == 0) {
    for (Slot& slot : m_slots)
      slot.round = 0;
    m_round = 1;
  }
}

std::size_t TePatchMemo::find(std::uint64_t key) const {
  const std::size_t mask = m_slots.size() - 1;
  std::size_t slot = std::size_t(key * 0x9E3779B97F4A7C15u >> 32) & mask;
  while (m_slots[slot].round == m_round && m_slots[slot].key != key)
    slot = (slot + 1) & mask;
  return slot;
}

std::size_t TePatchMemo::insert(std::uint64_t key, double number) {
  if (2 * ++m_used > m_slots.size()) {
    std::vector<Slot> old(2 * m_slots.size());
    old.swap(m_slots);
    for (const Slot& slot : old)
      if (slot.round == m_round)
        m_slots[find(slot.key)] = slot;
  }
  const std::size_t slot = find(key);
  m_slots[slot] = {key, number, m_round};
  return slot;
}
