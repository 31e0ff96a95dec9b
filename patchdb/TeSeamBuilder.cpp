#include "patchdb/TeSeamBuilder.h"

#include "patchdb/TeMeshBuilder.h"

namespace {

/// The patch `step` away, if it can take part.
TeResult<const TePatchData*> partner(const TePatchData& patch, glm::ivec2 step) {
  const TePatchData* other = &patch;
  for (TeDirection direction : kTeDirections)
    if (teStep(direction) == step)
      other = patch.neighbour(direction);
  if (other && other->hasHeights())
    return other;
  const TePatchKey key{patch.key().x + step.x, patch.key().y + step.y, patch.key().level};
  return TeError{"seam of patch " + patch.key().text() + ": patch " + key.text() + " has no heights yet"};
}

} // namespace

TeResult<TePatchMesh> teBuildSeam(const TeLattice& lattice, const TePatchData& patch, TeDirection direction) {
  // The patches that meet lie at low .. low + extent from this one.
  const glm::ivec2 step = teStep(direction);
  const glm::ivec2 low{step.x < 0 ? -1 : 0, step.y < 0 ? -1 : 0};
  const glm::ivec2 extent{step.x != 0 ? 1 : 0, step.y != 0 ? 1 : 0};
  const TePatchData* patches[2][2] = {};
  for (int y = 0; y <= extent.y; ++y)
    for (int x = 0; x <= extent.x; ++x) {
      const TeResult<const TePatchData*> found = partner(patch, low + glm::ivec2(x, y));
      if (!found)
        return found.error();
      patches[y][x] = *found;
    }
  TePatchMesh mesh;
  mesh.key = patches[0][0]->key();
  mesh.part = extent.x + extent.y == 2 ? TeSurfacePart::Corner : TeSurfacePart::Seam;
  mesh.direction = extent.x + extent.y == 2 ? TeDirection::NorthEast
                   : extent.x == 1          ? TeDirection::East
                                            : TeDirection::North;

  // Across a border the block has samples n-1 .. n+1 of the south-west patch, along it 1 .. n-1.
  const int n = lattice.cells();
  const glm::ivec2 first{extent.x ? n - 1 : 1, extent.y ? n - 1 : 1};
  const glm::ivec2 size{extent.x ? 3 : n - 1, extent.y ? 3 : n - 1};
  const glm::ivec2 ringed = size + 2;
  std::vector<float> heights(std::size_t(ringed.x) * std::size_t(ringed.y));
  float* out = heights.data();
  for (int y = first.y - 1; y < first.y - 1 + ringed.y; ++y)
    for (int x = first.x - 1; x < first.x - 1 + ringed.x; ++x) {
      const int beyondX = x > n ? 1 : 0;
      const int beyondY = y > n ? 1 : 0;
      *out++ = patches[beyondY][beyondX]->heights().at(x - beyondX * n, y - beyondY * n);
    }

  TeMeshBlock block;
  block.heights = heights.data() + ringed.x + 1;
  block.stride = ringed.x;
  block.columns = size.x;
  block.rows = size.y;
  for (int y = 0; y <= extent.y; ++y)
    for (int x = 0; x <= extent.x; ++x)
      block.missing = block.missing || patches[y][x]->hasMissing();
  const std::int64_t spacing = std::int64_t(1) << mesh.key.level;
  block.first = tePatchFirstSample(lattice, mesh.key) + glm::vec<2, std::int64_t>(first) * spacing;
  return TeMeshBuilder(lattice, block, std::move(mesh)).finish();
}
