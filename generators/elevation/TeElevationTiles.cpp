#include "generators/elevation/TeElevationTiles.h"

#include "generators/TeHeightMap.h"
#include "generators/base/TeFloatEnvironment.h"
#include "generators/elevation/TeGdal.h"

#include <algorithm>

namespace {

constexpr int kSideBits = 7;
// Filling reads a tile's surrounding too, which pays only for larger tiles.
constexpr int kFilledSideBits = 9;

std::uint64_t tileKey(int across, int down) { return std::uint64_t(down) << 32 | std::uint32_t(across); }

} // namespace

TeElevationTiles::TeElevationTiles(std::unique_ptr<TeRasterFile> raster, const TeElevationOptions& options,
                                   double metresPerStep)
    : m_raster(std::move(raster)), m_info(m_raster->info()), m_decoder(m_info, options, metresPerStep),
      m_terrarium(options.encoding == TeElevationEncoding::Terrarium), m_band(options.band),
      m_fillDistance(options.fillDistance),
      m_sideBits(options.fillDistance > 0 ? kFilledSideBits : kSideBits) {}

TeResult<TeElevationTiles::TilePtr> TeElevationTiles::tile(int across, int down) const {
  const std::uint64_t key = tileKey(across, down);
  {
    const std::lock_guard<std::mutex> lock(m_cacheMutex);
    const auto found = m_cache.find(key);
    if (found != m_cache.end()) {
      found->second.lastUse = ++m_clock;
      return found->second.tile;
    }
  }
  TeResult<TilePtr> tile = load(across, down);
  if (tile)
    insert(key, *tile);
  return tile;
}

std::size_t TeElevationTiles::cachedBytes() const {
  const std::lock_guard<std::mutex> lock(m_cacheMutex);
  return m_bytes;
}

void TeElevationTiles::insert(std::uint64_t key, const TilePtr& tile) const {
  const std::lock_guard<std::mutex> lock(m_cacheMutex);
  if (!m_cache.emplace(key, Entry{tile, ++m_clock}).second)
    return; // another thread was faster, with the same bits
  m_bytes += tile->heights.size() * sizeof(float);
  while (m_bytes > kCacheBytes && m_cache.size() > 1) {
    const auto oldest = std::min_element(m_cache.begin(), m_cache.end(), [](const auto& a, const auto& b) {
      return a.second.lastUse < b.second.lastUse;
    });
    m_bytes -= oldest->second.tile->heights.size() * sizeof(float);
    m_cache.erase(oldest);
  }
}

TeResult<TeElevationTiles::TilePtr> TeElevationTiles::load(int across, int down) const {
  const TeFloatEnvironment environment;
  auto tile = std::make_shared<TeElevationTile>();
  tile->column = across * side();
  tile->row = down * side();
  tile->columns = std::min(side(), m_info.columns - tile->column);
  const int rows = std::min(side(), m_info.rows - tile->row);
  if (TeStatus ok = readHeights({tile->column, tile->row, tile->columns, rows}, tile->heights); !ok)
    return ok.error();
  const bool voids = std::any_of(tile->heights.begin(), tile->heights.end(), TeHeightMap::isMissing);
  if (voids && m_fillDistance > 0)
    if (TeStatus ok = fill(*tile, rows, tile->heights); !ok)
      return ok.error();
  return TilePtr(std::move(tile));
}

TeStatus TeElevationTiles::readHeights(TeRasterWindow window, std::vector<float>& heights) const {
  const std::size_t count = std::size_t(window.columns) * window.rows;
  std::vector<double> samples(count);
  std::vector<double> green;
  std::vector<double> blue;
  {
    const std::lock_guard<std::mutex> lock(m_rasterMutex);
    if (TeStatus ok = m_raster->read(m_band, window, samples.data()); !ok)
      return ok;
    if (m_terrarium) {
      green.resize(count);
      blue.resize(count);
      if (TeStatus ok = m_raster->read(m_band + 1, window, green.data()); !ok)
        return ok;
      if (TeStatus ok = m_raster->read(m_band + 2, window, blue.data()); !ok)
        return ok;
    }
  }
  for (std::size_t i = 0; i < green.size(); ++i)
    samples[i] = samples[i] * 256 + green[i] + blue[i] / 256 - 32768;
  heights.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    heights[i] = m_decoder.height(samples[i]);
  return {};
}

TeStatus TeElevationTiles::fill(const TeElevationTile& tile, int rows, std::vector<float>& heights) const {
  const TeResult<const TeGdal*> gdal = TeGdal::module();
  if (!gdal)
    return TeError{"filling voids: " + gdal.error().message};
  const int margin = m_fillDistance + 2;
  TeRasterWindow window;
  window.column = std::max(tile.column - margin, 0);
  window.row = std::max(tile.row - margin, 0);
  window.columns =
      std::min(m_info.columns - tile.column, tile.columns + margin) + tile.column - window.column;
  window.rows = std::min(m_info.rows - tile.row, rows + margin) + tile.row - window.row;
  std::vector<float> around;
  if (TeStatus ok = readHeights(window, around); !ok)
    return ok;
  if (TeStatus ok = (*gdal)->fillVoids(around.data(), window.columns, window.rows, m_fillDistance); !ok)
    return ok;
  for (int r = 0; r < rows; ++r) {
    const std::size_t from =
        std::size_t(tile.row + r - window.row) * window.columns + std::size_t(tile.column - window.column);
    std::copy_n(around.begin() + std::ptrdiff_t(from), tile.columns,
                heights.begin() + std::ptrdiff_t(r) * tile.columns);
  }
  return {};
}
