#include "engine/terrain/TeGroundPins.h"

#include "engine/objects/TeObject.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

void TeGroundPins::findPlace(const TeObject& object, const TeLattice& lattice, bool ahead) {
  m_found.clear();
  const auto add = [&](const glm::dvec2& point) {
    if (const TeResult<TePatchKey> key = tePatchAt(lattice, point))
      if (m_found.empty() || m_found.back() != *key)
        m_found.push_back(*key);
  };
  // Half a patch a step, so that a patch is missed only where a corner is cut.
  const glm::dvec2 velocity(object.velocity());
  const double needed = std::ceil(2 * kSeconds * glm::length(velocity) / lattice.patchSide());
  const int steps = ahead ? int(std::min(needed, 2.0 * kPatchesAhead)) : 0;
  const double reach = object.groundReach();
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 middle =
        glm::dvec2(object.position()) + (i > 0 ? velocity * (kSeconds * i / needed) : glm::dvec2(0));
    if (reach > 0) {
      for (const double x : {-reach, reach})
        for (const double y : {-reach, reach})
          add(middle + glm::dvec2(x, y));
    } else {
      add(middle);
    }
  }
  std::sort(m_found.begin(), m_found.end());
  m_found.erase(std::unique(m_found.begin(), m_found.end()), m_found.end());
}

bool TeGroundPins::place(const TeObject& object, const TeLattice& lattice, bool ahead) {
  findPlace(object, lattice, ahead);
  Place& before = m_places[&object];
  if (m_found == before)
    return false;
  hold(m_found);
  release(before);
  before = m_found;
  return true;
}

void TeGroundPins::remove(const TeObject& object) {
  const auto found = m_places.find(&object);
  if (found == m_places.end())
    return;
  release(found->second);
  m_places.erase(found);
}

void TeGroundPins::hold(const Place& place) {
  for (const TePatchKey& key : place)
    ++m_counts[key];
}

void TeGroundPins::release(const Place& place) {
  for (const TePatchKey& key : place)
    if (--m_counts[key] == 0)
      m_counts.erase(key);
}
