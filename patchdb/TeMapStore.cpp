#include "patchdb/TeMapStore.h"

#include "generators/base/TeHash.h"

std::size_t TeMapStore::KeyHash::operator()(const TeMapKey& key) const {
  return std::size_t(teHashCombine(std::uint64_t(key.x), std::uint64_t(key.y)));
}

TeResult<TeHeightSourcePtr> TeMapStore::source(TeMapKey key, const TeSourceChooser& chooser) {
  if (TeHeightSourcePtr known = source(key))
    return known;
  TeHeightSourcePtr chosen = chooser.choose(key);
  if (!chosen)
    return TeError{"source map (" + std::to_string(key.x) + ", " + std::to_string(key.y) +
                   "): the chooser has no source for it"};
  m_entries[key].source = chosen;
  return chosen;
}

TeHeightSourcePtr TeMapStore::source(TeMapKey key) const {
  const auto found = m_entries.find(key);
  return found == m_entries.end() ? nullptr : found->second.source;
}

TeSourceMapPtr TeMapStore::find(TeMapKey key) const {
  const auto found = m_entries.find(key);
  return found == m_entries.end() ? nullptr : found->second.map.lock();
}

TeSourceMapPtr TeMapStore::add(TeMapKey key, TeHeightMap heights) {
  if (TeSourceMapPtr known = find(key))
    return known;
  Entry& entry = m_entries[key];
  assert(entry.source);
  auto map = std::make_shared<const TeSourceMap>(TeSourceMap{key, entry.source, std::move(heights)});
  entry.map = map;
  return map;
}

std::size_t TeMapStore::residentMaps() const {
  std::size_t count = 0;
  for (const auto& [key, entry] : m_entries)
    count += entry.map.expired() ? 0 : 1;
  return count;
}

std::size_t TeMapStore::residentBytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, entry] : m_entries)
    if (const TeSourceMapPtr map = entry.map.lock())
      bytes += map->heights.bytes();
  return bytes;
}
