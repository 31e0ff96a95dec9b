#include "nodes/terrain/TeStaticBlock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

TeStatus checkSize(const TeLattice& lattice, int patches) {
  if (patches < 1)
    return TeError{"block " + std::to_string(patches) + ": at least 1 patch a side is needed"};
  const std::int64_t perSide = std::int64_t(patches) * (lattice.cells() + 1);
  const std::int64_t longest = std::int64_t(std::sqrt(double(TeStaticBlock::kMaxSamples)));
  if (perSide > longest)
    return TeError{"block " + std::to_string(patches) + " with " + std::to_string(lattice.samples()) +
                   " samples a map: " + std::to_string(perSide) + " heights a side are more than " +
                   std::to_string(longest)};
  return {};
}

/// Leaves of [begin, end] along a ray what lies between two parallel planes; false if nothing.
bool clip(double origin, double direction, double low, double high, double& begin, double& end) {
  if (direction == 0)
    return origin >= low && origin <= high;
  const double a = (low - origin) / direction;
  const double b = (high - origin) / direction;
  begin = std::max(begin, std::min(a, b));
  end = std::min(end, std::max(a, b));
  return begin <= end;
}

} // namespace

TeResult<TeStaticBlock> TeStaticBlock::build(TeWorld world, glm::dvec2 centre, int patches,
                                             const Progress& progress) {
  const TeLattice lattice = world.lattice;
  if (TeStatus status = checkSize(lattice, patches); !status)
    return status.error();
  // An even block has a patch corner in its middle: that of the patch half a side farther on.
  const double shift = patches % 2 == 0 ? 0.5 * lattice.patchSide() : 0.0;
  const TeResult<TePatchKey> middle = tePatchAt(lattice, {centre.x + shift, centre.y + shift});
  if (!middle)
    return middle.error();
  TeResult<std::unique_ptr<TePatchDatabase>> database = TePatchDatabase::create(std::move(world));
  if (!database)
    return database.error();

  TeStaticBlock block;
  block.m_database = std::move(*database);
  block.m_patches = patches;
  block.m_first = {middle->x - patches / 2, middle->y - patches / 2, 0};
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  double sum = 0;
  std::int64_t present = 0;
  for (int y = 0; y < patches; y++) {
    for (int x = 0; x < patches; x++) {
      const TePatchKey key = {block.m_first.x + x, block.m_first.y + y, 0};
      const TeResult<TePatchData*> patch = block.m_database->build(key);
      if (!patch)
        return patch.error();
      const TeHeightMap& heights = (*patch)->heights();
      const TeMapStatistics statistics = heights.statistics();
      if (statistics.present > 0) {
        lowest = std::min(lowest, statistics.minimum);
        highest = std::max(highest, statistics.maximum);
        sum += statistics.mean * double(statistics.present);
        present += statistics.present;
      }
      if (progress)
        progress(y * patches + x + 1, patches * patches);
    }
  }
  if (lowest <= highest) {
    block.m_minimum = lowest;
    block.m_maximum = highest;
    block.m_mean = float(sum / double(present));
  }
  return block;
}

glm::dvec2 TeStaticBlock::centre() const {
  const TeWorldRect all = rect();
  return 0.5 * (all.southWest + all.northEast);
}

TeWorldRect TeStaticBlock::inset(int cells) const {
  const std::int64_t n = lattice().cells();
  const auto position = [&](std::int64_t sample) { return lattice().position(sample); };
  return {{position(m_first.x * n + cells), position(m_first.y * n + cells)},
          {position((m_first.x + m_patches) * n - cells), position((m_first.y + m_patches) * n - cells)}};
}

TeStatus TeStaticBlock::forEachPiece(const std::function<void(const TePatchMesh&)>& use) const {
  for (int y = 0; y < m_patches; y++) {
    for (int x = 0; x < m_patches; x++) {
      const TePatchData& patch = *m_database->find({m_first.x + x, m_first.y + y, 0});
      const TeResult<TePatchMesh> inside = m_database->patchMesh(patch);
      if (!inside)
        return inside.error();
      if (!inside->strips.empty())
        use(*inside);
      const bool hasEast = x + 1 < m_patches;
      const bool hasNorth = y + 1 < m_patches;
      for (TeDirection direction : {TeDirection::East, TeDirection::North, TeDirection::NorthEast}) {
        const glm::ivec2 step = teStep(direction);
        if ((step.x > 0 && !hasEast) || (step.y > 0 && !hasNorth))
          continue;
        const TeResult<TePatchMesh> seam = m_database->seamMesh(patch, direction);
        if (!seam)
          return seam.error();
        if (!seam->strips.empty())
          use(*seam);
      }
    }
  }
  return {};
}

std::optional<TeRayHit> TeStaticBlock::intersect(glm::dvec3 origin, glm::dvec3 direction) const {
  const TeWorldRect drawn = drawnRect();
  double begin = 0;
  double end = std::numeric_limits<double>::infinity();
  if (!clip(origin.x, direction.x, drawn.southWest.x, drawn.northEast.x, begin, end) ||
      !clip(origin.y, direction.y, drawn.southWest.y, drawn.northEast.y, begin, end))
    return std::nullopt;
  std::optional<TeRayHit> hit = m_database->intersect(origin + begin * direction, direction, end - begin);
  if (hit)
    hit->distance += begin;
  return hit;
}
