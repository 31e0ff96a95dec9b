#include "engine/terrain/TeTerrainPlan.h"

#include "engine/terrain/TeLookAhead.h"

void TeTerrainPlan::setRadius(int radius) {
  m_radius = radius;
  m_radiusChanged = m_radius != m_block.radius;
}

void TeTerrainPlan::place(const TeObject& object, const TeLattice& lattice, bool active) {
  m_pinsChanged = m_pins.place(object, lattice, !active) || m_pinsChanged;
}

void TeTerrainPlan::forget(const TeObject& object) {
  m_pins.remove(object);
  m_pinsChanged = true;
}

bool TeTerrainPlan::update(const TeLattice& lattice, const TeTerrainView& view) {
  const bool pinsChanged = std::exchange(m_pinsChanged, false);
  m_radiusChanged = m_blockChanged = m_jumped = false;
  const TeResult<TePatchKey> centre = tePatchAt(lattice, {view.position.x, view.position.y});
  if (!centre)
    return pinsChanged;
  std::vector<TePatchKey> centres =
      TeLookAhead::centres(lattice, glm::dvec2(view.position), glm::dvec2(view.velocity));
  const TePatchBlock next{*centre, m_radius};
  m_blockChanged = !m_known || !(next == m_block);
  if (m_blockChanged) {
    m_jumped = m_known && !(TePatchBlock{*centre, m_radius + m_block.radius}.contains(m_block.centre));
    m_block = next;
    m_known = true;
  }
  const bool changed = m_blockChanged || pinsChanged || centres != m_centres;
  m_centres = std::move(centres);
  return changed;
}

bool TeTerrainPlan::drawable(const TePatchKey& key) const {
  if (m_block.contains(key))
    return true;
  for (const TePatchKey& centre : m_centres)
    if (TePatchBlock{centre, m_block.radius}.contains(key))
      return true;
  return false;
}
