#include "patchdb/TePatchTree.h"

TeResult<TePatchData*> TePatchTree::lookup(const TePatchKey& key, TeLookup strategy) {
  if (!key.valid())
    return TeError{"patch " + key.text() + ": outside the world"};
  if (TePatchData* known = find(key))
    return known;
  switch (strategy) {
  case TeLookup::Create:
    return &create(key);
  case TeLookup::NearestCoarser:
    for (int coarser = key.level + 1; coarser < int(m_levels.size()); ++coarser)
      if (TePatchData* known = find(*key.ancestor(coarser)))
        return known;
    return nullptr;
  case TeLookup::Null:
    break;
  }
  return nullptr;
}

TePatchData* TePatchTree::nearestWithHeights(const TePatchKey& key) const {
  TePatchData* known = find(key);
  if (known && known->hasHeights())
    return known;
  for (int coarser = key.level + 1; coarser < int(m_levels.size()); ++coarser) {
    known = find(*key.ancestor(coarser));
    if (known && known->hasHeights())
      return known;
  }
  return nullptr;
}

TePatchData& TePatchTree::create(const TePatchKey& key) {
  if (int(m_levels.size()) <= key.level)
    m_levels.resize(std::size_t(key.level) + 1);
  TeGrowingTree& tree = m_levels[std::size_t(key.level)];
  TePatchData& patch = tree.insert(key.x, key.y, std::make_unique<TePatchData>(key));
  for (TeDirection direction : kTeDirections) {
    const glm::ivec2 step = teStep(direction);
    if (TePatchData* other = tree.find(key.x + step.x, key.y + step.y))
      TePatchData::link(patch, direction, *other);
  }
  return patch;
}

bool TePatchTree::remove(const TePatchKey& key) {
  if (!find(key))
    return false;
  // Its destructor takes it out of its neighbours.
  m_levels[std::size_t(key.level)].remove(key.x, key.y);
  return true;
}

std::size_t TePatchTree::size() const {
  std::size_t sum = 0;
  for (const TeGrowingTree& tree : m_levels)
    sum += tree.size();
  return sum;
}

std::size_t TePatchTree::bytes() const {
  std::size_t sum = 0;
  for (const TeGrowingTree& tree : m_levels)
    sum += tree.bytes();
  return sum;
}
