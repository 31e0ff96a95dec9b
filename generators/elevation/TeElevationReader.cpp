#include "generators/elevation/TeElevationReader.h"

#include "generators/TeHeightMap.h"

#include <algorithm>
#include <cmath>

TeStatus TeElevationReader::tileOf(int column, int row, const TeElevationTile*& tile) {
  const int across = column >> m_sideBits;
  const int down = row >> m_sideBits;
  Slot& slot = m_slots[std::size_t((across & 1) + 2 * (down & 1))];
  if (slot.across != across || slot.down != down) {
    TeResult<TeElevationTiles::TilePtr> taken = m_file->tiles().tile(across, down);
    if (!taken)
      return TeError{m_file->path() + ": " + taken.error().message};
    slot = {across, down, std::move(*taken)};
    ++m_tilesTaken;
  }
  tile = slot.tile.get();
  return {};
}

TeStatus TeElevationReader::post(int column, int row, float& height) {
  const TeElevationTile* tile = nullptr;
  if (TeStatus ok = tileOf(column, row, tile); !ok)
    return ok;
  height = tile->heights[std::size_t(row - tile->row) * tile->columns + std::size_t(column - tile->column)];
  return {};
}

TeStatus TeElevationReader::height(TePlanePoint posts, float& height) {
  if (std::isnan(posts.x) || std::isnan(posts.y)) {
    height = TeHeightMap::missing();
    return {};
  }
  const double u = std::clamp(posts.x, 0.0, double(m_file->columns() - 1));
  const double v = std::clamp(posts.y, 0.0, double(m_file->rows() - 1));
  const int column = int(u);
  const int row = int(v);
  const double fx = u - column;
  const double fy = v - row;
  const int east = fx > 0 ? column + 1 : column;
  const int south = fy > 0 ? row + 1 : row;

  float h[4]; // north-west, north-east, south-west, south-east
  const TeElevationTile* tile = nullptr;
  if (TeStatus ok = tileOf(column, row, tile); !ok)
    return ok;
  if (column >> m_sideBits == east >> m_sideBits && row >> m_sideBits == south >> m_sideBits) {
    const float* const north =
        tile->heights.data() + std::size_t(row - tile->row) * tile->columns + (column - tile->column);
    const float* const below = north + std::size_t(south - row) * tile->columns;
    h[0] = north[0];
    h[1] = north[east - column];
    h[2] = below[0];
    h[3] = below[east - column];
  } else {
    const int columns[] = {column, east};
    const int rows[] = {row, south};
    for (int i = 0; i < 4; ++i)
      if (TeStatus ok = post(columns[i & 1], rows[i >> 1], h[i]); !ok)
        return ok;
  }
  const double north = fx > 0 ? (1 - fx) * h[0] + fx * h[1] : h[0];
  const double below = fx > 0 ? (1 - fx) * h[2] + fx * h[3] : h[2];
  const float value = float(fy > 0 ? (1 - fy) * north + fy * below : north);
  height = TeHeightMap::isMissing(value) ? TeHeightMap::missing() : value;
  return {};
}
