#include "generators/elevation/TeElevationReader.h"

#include "generators/TeHeightMap.h"

#include <algorithm>
#include <cmath>

TeStatus TeElevationReader::post(int column, int row, float& height) {
  const int side = m_file->tiles().side();
  const int across = column / side;
  const int down = row / side;
  Slot& slot = m_slots[std::size_t((across & 1) + 2 * (down & 1))];
  if (slot.across != across || slot.down != down) {
    TeResult<TeElevationTiles::TilePtr> tile = m_file->tiles().tile(across, down);
    if (!tile)
      return TeError{m_file->path() + ": " + tile.error().message};
    slot = {across, down, std::move(*tile)};
    ++m_tilesTaken;
  }
  const TeElevationTile& tile = *slot.tile;
  height = tile.heights[std::size_t(row - tile.row) * tile.columns + std::size_t(column - tile.column)];
  return {};
}

TeStatus TeElevationReader::height(TePlanePoint posts, float& height) {
  const double u = std::clamp(posts.x, 0.0, double(m_file->columns() - 1));
  const double v = std::clamp(posts.y, 0.0, double(m_file->rows() - 1));
  const int column = int(std::floor(u));
  const int row = int(std::floor(v));
  const double fx = u - column;
  const double fy = v - row;
  float h00 = 0;
  float h10 = 0;
  float h01 = 0;
  float h11 = 0;
  if (TeStatus ok = post(column, row, h00); !ok)
    return ok;
  if (fx > 0)
    if (TeStatus ok = post(column + 1, row, h10); !ok)
      return ok;
  if (fy > 0)
    if (TeStatus ok = post(column, row + 1, h01); !ok)
      return ok;
  if (fx > 0 && fy > 0)
    if (TeStatus ok = post(column + 1, row + 1, h11); !ok)
      return ok;
  const double north = fx > 0 ? (1 - fx) * h00 + fx * h10 : h00;
  const double south = fx > 0 ? (1 - fx) * h01 + fx * h11 : h01;
  const float value = float(fy > 0 ? (1 - fy) * north + fy * south : north);
  height = TeHeightMap::isMissing(value) ? TeHeightMap::missing() : value;
  return {};
}
