#include "apps/terrane-accuracy/TeHeightWorld.h"

#include "generators/midpoint/TeMidpointDisplacement.h"

#include <algorithm>

namespace {

template <class Visit> void forEachPatch(const TePatchDatabase& database, int level, const Visit& visit) {
  database.tree().level(level).traverse([](const TeGrowingTree::Bounds&) { return 0.0; },
                                        [&](const TePatchData& patch) {
                                          visit(patch);
                                          return true;
                                        });
}

TeStatus addBasePatch(const TeMeasuredTerrain& terrain, const TePatchKey& key, TePatchDatabase& database) {
  constexpr int kCells = TeHeightWorld::kCells;
  TeResult<TeHeightMap> part = TeHeightMap::create(kCells + 1, kCells + 1);
  if (!part)
    return part.error();
  const TeMapRect from{int(key.x) * kCells, int(key.y) * kCells, kCells + 1, kCells + 1};
  if (const TeStatus ok =
          part->addScaled(terrain.heights(), float(terrain.heightScale()), from, part->bounds());
      !ok)
    return ok;
  const TeResult<TePatchData*> patch = database.lookup(key, TeLookup::Create);
  if (!patch)
    return patch.error();
  (*patch)->setHeights(std::move(*part));
  return {};
}

} // namespace

TeResult<TeHeightWorld> TeHeightWorld::create(const TeMeasuredTerrain& terrain, int levels,
                                              const std::function<void(double)>& progress) {
  const int patches = terrain.cells() / kCells;
  if (patches < 1)
    return TeError{terrain.name + ": at least 33 samples a side are needed"};
  const TeResult<TeLattice> lattice = TeLattice::create(2 * kCells + 1, terrain.spacing());
  if (!lattice)
    return lattice.error();
  // Never asked, as all heights are set.
  const auto sources = std::make_shared<TeSingleSource>(TeMidpointDisplacement::create({}).value());
  TeResult<std::unique_ptr<TePatchDatabase>> database = TePatchDatabase::create({*lattice, 0, sources});
  if (!database)
    return database.error();
  TeHeightWorld world(std::move(*database));
  while (world.m_levels < levels && (1 << world.m_levels) <= patches)
    ++world.m_levels;
  world.m_side = terrain.cells() * terrain.spacing();
  world.m_corner = lattice->position(0);
  world.m_samples = std::int64_t(terrain.heights().bytes() / sizeof(float));
  for (int level = 0; level < world.m_levels; ++level) {
    const int side = patches >> level;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const TePatchKey key{x, y, level};
        const TeStatus ok = level == 0 ? addBasePatch(terrain, key, *world.m_database) : [&]() -> TeStatus {
          const TeResult<TePatchData*> coarse = world.m_database->buildCoarse(key);
          return coarse ? TeStatus() : TeStatus(coarse.error());
        }();
        if (!ok)
          return ok.error();
      }
      progress((level + (y + 1.0) / side) / world.m_levels);
    }
  }
  return world;
}

double TeHeightWorld::bytesPerSample(int level) const {
  std::size_t bytes = m_database->tree().level(level).bytes();
  forEachPatch(*m_database, level, [&](const TePatchData& patch) { bytes += patch.bytes(); });
  return double(bytes) / double(m_samples);
}

double TeHeightWorld::worstDeviation(int level) const {
  double worst = 0;
  forEachPatch(*m_database, level,
               [&](const TePatchData& patch) { worst = std::max(worst, double(patch.deviation())); });
  return worst;
}
