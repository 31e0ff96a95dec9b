#include "nodes/lod/drawing/TeLodPartStore.h"

#include <algorithm>
#include <utility>
#include <vector>

const TeLodSender::Kept* TeLodPartStore::find(std::uint64_t key) {
  const auto found = m_parts.find(key);
  if (found == m_parts.end())
    return nullptr;
  found->second.frame = m_frame;
  return &found->second.part;
}

const TeLodSender::Kept* TeLodPartStore::add(std::uint64_t key, TeLodArrays& arrays) {
  // Without indices it may be up to six times as large.
  const std::size_t most =
      std::max(arrays.bytes(), 3 * std::size_t(arrays.triangles()) * sizeof(TeDrawnVertex));
  if (m_bytes + most > m_limit)
    makeRoom(most);
  if (m_bytes + most > m_limit)
    return nullptr;
  Entry& entry = m_parts[key];
  entry.part = m_sender.keep(std::move(arrays));
  entry.frame = m_frame;
  m_bytes += entry.part.bytes;
  return &entry.part;
}

void TeLodPartStore::makeRoom(std::size_t bytes) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> unused; // frame, key
  for (const auto& [key, entry] : m_parts)
    if (entry.frame < m_frame)
      unused.emplace_back(entry.frame, key);
  std::sort(unused.begin(), unused.end());
  // An eighth more than is needed, so that it is not needed again at once.
  const std::size_t wanted = m_limit - std::min(m_limit, bytes + m_limit / 8);
  for (const auto& [frame, key] : unused) {
    if (m_bytes <= wanted)
      return;
    const auto entry = m_parts.find(key);
    m_sender.free(entry->second.part);
    m_bytes -= entry->second.part.bytes;
    m_parts.erase(entry);
  }
}

void TeLodPartStore::clear() {
  for (const auto& [key, entry] : m_parts)
    m_sender.free(entry.part);
  m_parts.clear();
  m_bytes = 0;
}
