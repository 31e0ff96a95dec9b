#include "patchdb/TeMapStore.h"

#include "patchdb/TeResidentMaps.h"

#include <string>

TeMapStore::TeMapStore(std::shared_ptr<const TeSourceChooser> chooser)
    : m_resident(std::make_shared<TeResidentMaps>()) {
  m_epochs.push_back({std::move(chooser), {}});
}

TeMapStore::~TeMapStore() = default;

void TeMapStore::setChooser(std::shared_ptr<const TeSourceChooser> chooser) {
  if (m_epochs.back().begun.empty())
    m_epochs.back().chooser = std::move(chooser);
  else
    m_epochs.push_back({std::move(chooser), {}});
}

const TeMapStore::Epoch* TeMapStore::epochOf(TeMapKey key) const {
  for (auto epoch = m_epochs.rbegin(); epoch != m_epochs.rend(); ++epoch)
    if (epoch->begun.contains(key.x, key.y))
      return &*epoch;
  return nullptr;
}

TeResult<TeHeightSourcePtr> TeMapStore::begin(TeMapKey key) {
  if (TeHeightSourcePtr known = source(key))
    return known;
  TeHeightSourcePtr chosen = m_epochs.back().chooser->choose(key);
  if (!chosen)
    return TeError{"source map (" + std::to_string(key.x) + ", " + std::to_string(key.y) +
                   "): the chooser has no source for it"};
  m_epochs.back().begun.insert(key.x, key.y);
  return chosen;
}

TeHeightSourcePtr TeMapStore::source(TeMapKey key) const {
  const Epoch* epoch = epochOf(key);
  return epoch ? epoch->chooser->choose(key) : nullptr;
}

TeSourceMapPtr TeMapStore::find(TeMapKey key) const { return m_resident->find(key); }

TeSourceMapPtr TeMapStore::add(TeMapKey key, TeHeightMap heights) {
  if (TeSourceMapPtr known = find(key))
    return known;
  TeHeightSourcePtr made = source(key);
  assert(made);
  return TeResidentMaps::add(m_resident, {key, std::move(made), std::move(heights)});
}

std::size_t TeMapStore::residentMaps() const { return m_resident->size(); }
std::size_t TeMapStore::residentBytes() const { return m_resident->bytes(); }

std::size_t TeMapStore::begunMaps() const {
  std::size_t keys = 0;
  for (const Epoch& epoch : m_epochs)
    keys += epoch.begun.size();
  return keys;
}

std::size_t TeMapStore::recordBytes() const {
  std::size_t bytes = m_epochs.capacity() * sizeof(Epoch);
  for (const Epoch& epoch : m_epochs)
    bytes += epoch.begun.bytes();
  return bytes;
}
