#include "engine/terrain/TeLookAhead.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace {

/// -1, 0 or 1: the edge that a place within a patch, 0 .. 1, is near to.
int nearEdge(double place) {
  if (place < TeLookAhead::kEdge)
    return -1;
  return place > 1 - TeLookAhead::kEdge ? 1 : 0;
}

void add(const TePatchKey& key, const TePatchKey& own, std::vector<TePatchKey>& keys) {
  if (key.valid() && key != own && std::find(keys.begin(), keys.end(), key) == keys.end())
    keys.push_back(key);
}

} // namespace

std::vector<TePatchKey> TeLookAhead::centres(const TeLattice& lattice, glm::dvec2 position,
                                             glm::dvec2 velocity) {
  std::vector<TePatchKey> keys;
  const TeResult<TePatchKey> own = tePatchAt(lattice, position);
  if (!own)
    return keys;

  const double side = lattice.patchSide();
  const glm::dvec2 place = (position - tePatchOrigin(lattice, *own)) / side;
  const int dx = nearEdge(place.x);
  const int dy = nearEdge(place.y);
  add({own->x + dx, own->y + dy, 0}, *own, keys);

  const double way = glm::length(velocity) * kSeconds;
  if (!(way > 0))
    return keys;
  // A quarter of a patch a step: at most a corner is cut so closely that its patch is crossed in no time.
  const double needed = std::ceil(4 * way / side);
  const double steps = std::min(needed, 4.0 * kMaxCentres);
  const glm::dvec2 step = velocity * (kSeconds / needed);
  for (int i = 1; i <= int(steps) && int(keys.size()) < kMaxCentres; ++i)
    if (const TeResult<TePatchKey> key = tePatchAt(lattice, position + double(i) * step))
      add(*key, *own, keys);
  return keys;
}
