#include "patchdb/TeMeshBuilder.h"

#include "generators/TeHeightMap.h"
#include "patchdb/TeSurfaceNormals.h"

#include <cmath>

namespace {

/// Strips along the rows of cells. North before south in each pair makes the diagonal run south-west to
/// north-east and the triangles counter-clockwise.
void addStrips(const TeMeshBlock& block, TePatchMesh& mesh) {
  if (!block.missing) {
    mesh.strips.resize(std::size_t(block.rows - 1) * (2 * std::size_t(block.columns) + 1));
    std::int32_t* out = mesh.strips.data();
    for (std::int32_t y = 0; y + 1 < block.rows; ++y) {
      for (std::int32_t south = y * block.columns; south < (y + 1) * block.columns; ++south) {
        *out++ = south + block.columns;
        *out++ = south;
      }
      *out++ = -1;
    }
    return;
  }
  const auto missing = [&](int x, int y) {
    return TeHeightMap::isMissing(block.heights[std::ptrdiff_t(y) * block.stride + x]);
  };
  for (int y = 0; y + 1 < block.rows; ++y) {
    bool open = false;
    for (int x = 0; x + 1 < block.columns; ++x) {
      const std::int32_t south = y * block.columns + x;
      const std::int32_t north = south + block.columns;
      if (missing(x, y) || missing(x + 1, y) || missing(x, y + 1) || missing(x + 1, y + 1)) {
        if (open)
          mesh.strips.push_back(-1);
        open = false;
        continue;
      }
      if (!open)
        mesh.strips.insert(mesh.strips.end(), {north, south});
      mesh.strips.insert(mesh.strips.end(), {north + 1, south + 1});
      open = true;
    }
    if (open)
      mesh.strips.push_back(-1);
  }
}

} // namespace

void teBuildMesh(const TeLattice& lattice, const TeMeshBlock& block, TePatchMesh& mesh) {
  if (block.columns < 2 || block.rows < 2)
    return;
  const int level = mesh.key.level;
  const std::int64_t step = std::int64_t(1) << level;
  const double scale = teMeshScale(lattice, level);
  const auto coordinate = [&](std::int64_t sample) {
    return std::nearbyint(lattice.position(sample) * scale) / scale;
  };
  mesh.columns = block.columns;
  mesh.rows = block.rows;
  const double originX = coordinate(block.first.x + (block.columns / 2) * step);
  const double originY = coordinate(block.first.y + (block.rows / 2) * step);
  mesh.origin = {originX, originY, 0.0};

  std::vector<float> localX(std::size_t(block.columns));
  for (int x = 0; x < block.columns; ++x)
    localX[std::size_t(x)] = float(coordinate(block.first.x + x * step) - originX);
  mesh.positions.resize(std::size_t(block.columns) * std::size_t(block.rows));
  glm::vec3* position = mesh.positions.data();
  for (int y = 0; y < block.rows; ++y) {
    const float localY = float(coordinate(block.first.y + y * step) - originY);
    const float* row = block.heights + std::ptrdiff_t(y) * block.stride;
    for (int x = 0; x < block.columns; ++x)
      *position++ = {localX[std::size_t(x)], localY, TeHeightMap::isMissing(row[x]) ? 0.0f : row[x]};
  }
  mesh.normals.resize(mesh.positions.size());
  teGridNormals(block.heights, block.stride, block.columns, block.rows, lattice.spacing() * double(step),
                block.missing, mesh.normals.data());
  addStrips(block, mesh);
}
