#include "engine/TePatch.h"

#include "engine/TeEngine.h"

namespace {

/// A seam belongs to the patch from which it lies to the east, north-east or north.
struct SeamPlace {
  TePatchKey owner;
  TeDirection direction;
};

SeamPlace seamPlace(const TePatchKey& key, TeDirection direction) {
  const TePatchKey west{key.x - 1, key.y, key.level};
  const TePatchKey south{key.x, key.y - 1, key.level};
  switch (direction) {
  case TeDirection::NorthWest:
    return {west, TeDirection::NorthEast};
  case TeDirection::West:
    return {west, TeDirection::East};
  case TeDirection::SouthWest:
    return {{key.x - 1, key.y - 1, key.level}, TeDirection::NorthEast};
  case TeDirection::South:
    return {south, TeDirection::North};
  case TeDirection::SouthEast:
    return {south, TeDirection::NorthEast};
  default:
    return {key, direction};
  }
}

} // namespace

static_assert(int(TePatch::EAST) == int(TeDirection::East) &&
              int(TePatch::SOUTH_EAST) == int(TeDirection::SouthEast));

TePatch::TePatch(TeEngine& engine, TePatchData& data) : m_engine(engine), m_data(data) {}

SbVec2d TePatch::getCentre() const {
  const glm::dvec2 centre = tePatchCentre(m_engine.m_lattice, getKey());
  return SbVec2d(centre.x, centre.y);
}

SbBool TePatch::prepareBuildMaps() {
  if (!m_engine.updateParams())
    return FALSE;
  const TeStatus ok = m_engine.m_database->prepareBuildMaps(m_data);
  return ok ? TRUE : m_engine.fail(ok.error());
}

SbBool TePatch::buildHMapFromBuildMaps() {
  if (m_data.hasHeights())
    return TRUE;
  const TeStatus ok = m_engine.m_database->buildHeights(m_data);
  return ok ? TRUE : m_engine.fail(ok.error());
}

SoSeparator* TePatch::getPatchGraph() {
  if (m_graph)
    return m_graph.get();
  const TeResult<TePatchMesh> mesh = m_engine.m_database->patchMesh(m_data);
  if (!mesh) {
    m_engine.fail(mesh.error());
    return nullptr;
  }
  m_graph = m_engine.makeGraph(*mesh);
  return m_graph.get();
}

SoSeparator* TePatch::getSeamGraph(Direction direction) {
  if (direction < EAST || direction > SOUTH_EAST) {
    m_engine.fail(
        {"seam of patch " + getKey().text() + ": " + std::to_string(int(direction)) + " is no direction"});
    return nullptr;
  }
  const SeamPlace place = seamPlace(getKey(), TeDirection(direction));
  const auto owner = m_engine.m_patches.find(place.owner);
  TeNodePtr<SoSeparator>* kept = owner == m_engine.m_patches.end()
                                     ? nullptr
                                     : &owner->second->m_seamGraphs[std::size_t(place.direction)];
  if (kept && *kept)
    return kept->get();
  const TeResult<TePatchMesh> mesh = m_engine.m_database->seamMesh(m_data, TeDirection(direction));
  if (!mesh) {
    m_engine.fail(mesh.error());
    return nullptr;
  }
  assert(kept); // there is no seam without its owner
  *kept = m_engine.makeGraph(*mesh);
  return kept->get();
}
