#include "patchdb/TePatchIndex.h"

#include "patchdb/TePatchData.h"

#include <cassert>
#include <utility>

TePatchData* TePatchIndex::find(std::int64_t x, std::int64_t y) const {
  if (m_slots.empty())
    return nullptr;
  const std::uint64_t hash = hashOf(x, y);
  const std::size_t last = m_slots.size() - 1;
  for (std::size_t i = home(hash); m_slots[i].patch; i = (i + 1) & last)
    if (m_slots[i].hash == hash && m_slots[i].patch->key().x == x && m_slots[i].patch->key().y == y)
      return m_slots[i].patch;
  return nullptr;
}

void TePatchIndex::reserve(std::size_t patches) {
  if (2 * patches <= m_slots.size())
    return;
  std::size_t count = 4;
  int shift = 62;
  for (; count < 2 * patches; count *= 2)
    --shift;
  std::vector<Slot> slots(count);
  std::swap(slots, m_slots);
  m_shift = shift;
  m_size = 0;
  for (const Slot& slot : slots)
    if (slot.patch)
      add(*slot.patch);
}

void TePatchIndex::add(TePatchData& patch) {
  assert(2 * m_size < m_slots.size());
  const std::uint64_t hash = hashOf(patch.key().x, patch.key().y);
  const std::size_t last = m_slots.size() - 1;
  std::size_t i = home(hash);
  while (m_slots[i].patch)
    i = (i + 1) & last;
  m_slots[i] = {hash, &patch};
  ++m_size;
}

// Those behind it that are not at home move up, so that no look-up stops at the gap.
void TePatchIndex::remove(const TePatchData& patch) {
  const std::size_t last = m_slots.size() - 1;
  std::size_t gap = home(hashOf(patch.key().x, patch.key().y));
  while (m_slots[gap].patch != &patch)
    gap = (gap + 1) & last;
  for (std::size_t i = (gap + 1) & last; m_slots[i].patch; i = (i + 1) & last) {
    const std::size_t wanted = home(m_slots[i].hash);
    // How far it is from home, and how far it would be in the gap.
    if (((i - wanted) & last) >= ((i - gap) & last)) {
      m_slots[gap] = m_slots[i];
      gap = i;
    }
  }
  m_slots[gap] = {};
  --m_size;
}
