#include "patchdb/TeResidentMaps.h"

#include "generators/base/TeHash.h"

std::size_t TeResidentMaps::KeyHash::operator()(const TeMapKey& key) const {
  return std::size_t(teHashCombine(std::uint64_t(key.x), std::uint64_t(key.y)));
}

TeSourceMapPtr TeResidentMaps::find(TeMapKey key) const {
  const std::lock_guard lock(m_mutex);
  const auto found = m_maps.find(key);
  return found == m_maps.end() ? nullptr : found->second.map.lock();
}

TeSourceMapPtr TeResidentMaps::add(const std::shared_ptr<TeResidentMaps>& self, TeSourceMap map) {
  const auto drop = [self](const TeSourceMap* dropped) {
    self->remove(*dropped);
    delete dropped;
  };
  TeSourceMapPtr added(new TeSourceMap(std::move(map)), drop);
  const std::lock_guard lock(self->m_mutex);
  // Another map of this key may be on its way out in another thread; its place is taken.
  const auto [at, isNew] = self->m_maps.try_emplace(added->key);
  if (!isNew)
    self->m_bytes -= at->second.address->heights.bytes();
  at->second = {added.get(), added};
  self->m_bytes += added->heights.bytes();
  return added;
}

void TeResidentMaps::remove(const TeSourceMap& map) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_maps.find(map.key);
  if (found == m_maps.end() || found->second.address != &map)
    return;
  m_bytes -= map.heights.bytes();
  m_maps.erase(found);
}

std::size_t TeResidentMaps::size() const {
  const std::lock_guard lock(m_mutex);
  return m_maps.size();
}

std::size_t TeResidentMaps::bytes() const {
  const std::lock_guard lock(m_mutex);
  return m_bytes;
}
