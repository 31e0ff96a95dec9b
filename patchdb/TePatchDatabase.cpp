#include "patchdb/TePatchDatabase.h"

#include "patchdb/TeCoarseHeights.h"
#include "patchdb/TePatchJob.h"
#include "patchdb/TeSeamBuilder.h"

#include <new>

namespace {

/// Makes an error of a lack of memory.
template <class Work> auto guarded(Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return TeError{"out of memory"}; // short enough to need none
  }
}

} // namespace

TeResult<std::unique_ptr<TePatchDatabase>> TePatchDatabase::create(TeWorld world) {
  if (!world.sources)
    return TeError{"world: no source of heights given"};
  const double spacing = world.lattice.spacing();
  if (!(spacing >= kMinSpacing && spacing <= kMaxSpacing))
    return TeError{"spacing: " + std::to_string(spacing) + " m is not within " + std::to_string(kMinSpacing) +
                   " to " + std::to_string(kMaxSpacing)};
  return std::unique_ptr<TePatchDatabase>(new TePatchDatabase(std::move(world)));
}

TeStatus TePatchDatabase::setSources(std::shared_ptr<const TeSourceChooser> sources) {
  if (!sources)
    return TeError{"world: no source of heights given"};
  m_world.sources = std::move(sources);
  m_maps.setChooser(m_world.sources);
  return {};
}

TeResult<TePatchData*> TePatchDatabase::lookup(const TePatchKey& key, TeLookup strategy) {
  return guarded([&] { return m_tree.lookup(key, strategy); });
}

bool TePatchDatabase::remove(const TePatchKey& key) {
  m_surface.forget();
  return m_tree.remove(key);
}

TeStatus TePatchDatabase::prepareBuildMaps(TePatchData& patch) {
  TePatchJob job(*this, patch.key());
  TeAllowance all = TeAllowance::unlimited();
  if (job.makeMaps(all) == TeProgress::Failed)
    return job.error();
  patch.setMaps(job.maps());
  return {};
}

TeStatus TePatchDatabase::buildHeights(TePatchData& patch) {
  if (!patch.hasMaps())
    return TeError{"patch " + patch.key().text() + ": its source maps were not prepared"};
  return guarded([&]() -> TeStatus {
    TeResult<std::unique_ptr<TeHeightBuilder>> builder = TeHeightBuilder::create(patch.maps(), m_weights);
    if (!builder)
      return builder.error();
    TeAllowance all = TeAllowance::unlimited();
    (*builder)->step(all);
    patch.setHeights((*builder)->take());
    return {};
  });
}

TeResult<TePatchData*> TePatchDatabase::build(const TePatchKey& key) {
  if (TePatchData* known = find(key); known && known->hasHeights())
    return known;
  TePatchJob job(*this, key);
  if (job.finish() == TeProgress::Failed)
    return job.error();
  return find(key);
}

TeResult<TePatchData*> TePatchDatabase::buildCoarse(const TePatchKey& key) {
  return guarded([&]() -> TeResult<TePatchData*> {
    TeResult<TeCoarseHeights> coarse = teCoarseHeights(lattice(), m_tree, key);
    if (!coarse)
      return coarse.error();
    const TeResult<TePatchData*> patch = m_tree.lookup(key, TeLookup::Create);
    if (patch)
      (*patch)->setHeights(std::move(coarse->heights), coarse->deviation);
    return patch;
  });
}

TeResult<TeMeshBuilder> TePatchDatabase::meshBuilder(const TePatchData& patch) const {
  if (!patch.hasHeights())
    return TeError{"patch " + patch.key().text() + ": has no heights yet"};
  const int cells = lattice().cells();
  TeMeshBlock block;
  block.heights = patch.heights().row(1) + 1;
  block.stride = cells + 1;
  block.columns = block.rows = cells - 1;
  block.missing = patch.hasMissing();
  const std::int64_t step = std::int64_t(1) << patch.key().level;
  block.first = tePatchFirstSample(lattice(), patch.key()) + step;
  return guarded([&]() -> TeResult<TeMeshBuilder> {
    TePatchMesh mesh;
    mesh.key = patch.key();
    return TeMeshBuilder(lattice(), block, std::move(mesh));
  });
}

TeResult<TePatchMesh> TePatchDatabase::patchMesh(const TePatchData& patch) const {
  TeResult<TeMeshBuilder> builder = meshBuilder(patch);
  if (!builder)
    return builder.error();
  return builder->finish();
}

TeResult<TePatchMesh> TePatchDatabase::seamMesh(const TePatchData& patch, TeDirection direction) const {
  return guarded([&] { return teBuildSeam(lattice(), patch, direction); });
}

TeResult<TePatchMeshPtr> TePatchDatabase::seam(TePatchData& patch, TeDirection direction) {
  return guarded([&]() -> TeResult<TePatchMeshPtr> {
    if (!patch.seam(direction)) {
      TeResult<TePatchMesh> mesh = teBuildSeam(lattice(), patch, direction);
      if (!mesh)
        return mesh.error();
      patch.shareSeam(direction, std::make_shared<const TePatchMesh>(std::move(*mesh)));
    }
    return patch.seam(direction);
  });
}

std::optional<glm::dvec3> TePatchDatabase::normalAt(glm::dvec2 point) const {
  return m_surface.normalAt(point);
}

std::optional<TeSurfacePoint> TePatchDatabase::surfaceAt(glm::dvec2 point) const {
  return m_surface.pointAt(point);
}

std::optional<TeSurfacePoint> TePatchDatabase::surfaceAt(glm::dvec2 point, int level) const {
  return m_surface.pointAt(point, level);
}

std::optional<TeRayHit> TePatchDatabase::intersect(glm::dvec3 origin, glm::dvec3 direction,
                                                   double maxDistance, int level) const {
  return m_surface.intersect(origin, direction, maxDistance, level);
}
