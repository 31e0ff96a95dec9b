#include "engine/terrain/TeGroundPins.h"

#include "engine/objects/TeObject.h"

namespace {

std::optional<TePatchKey> patchAt(const TeLattice& lattice, const glm::dvec3& position) {
  const TeResult<TePatchKey> key = tePatchAt(lattice, {position.x, position.y});
  return key ? std::optional(*key) : std::nullopt;
}

} // namespace

bool TeGroundPins::place(const TeObject& object, const TeLattice& lattice) {
  Place place;
  std::size_t count = 0;
  const double reach = object.groundReach();
  for (const double seconds : {0.0, kSeconds}) {
    const glm::dvec3 middle = object.position() + seconds * object.velocity();
    if (reach > 0)
      for (const double x : {-reach, reach})
        for (const double y : {-reach, reach})
          place[count++] = patchAt(lattice, middle + glm::dvec3(x, y, 0));
    else
      place[count++] = patchAt(lattice, middle);
  }
  Place& before = m_places[&object];
  if (place == before)
    return false;
  hold(place);
  release(before);
  before = place;
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
  for (const std::optional<TePatchKey>& key : place)
    if (key)
      ++m_counts[*key];
}

void TeGroundPins::release(const Place& place) {
  for (const std::optional<TePatchKey>& key : place)
    if (key && --m_counts[*key] == 0)
      m_counts.erase(*key);
}
