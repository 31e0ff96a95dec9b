#pragma once

#include "generators/elevation/TeElevationOptions.h"
#include "generators/elevation/TePostDecoder.h"
#include "generators/elevation/TeRasterFile.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

/// Posts of one tile in metres; post (c, r) of the raster is heights[(r - row) * columns + (c - column)].
struct TeElevationTile {
  int column = 0;
  int row = 0;
  int columns = 0;
  std::vector<float> heights;
};

/// A raster's posts in metres, read in square tiles when first needed and kept in a bounded cache. A tile is
/// a function of the file and the options alone, whatever was read before: voids are filled tile by tile,
/// from a surrounding as wide as the filling may reach. Thread-safe.
class TeElevationTiles {
public:
  static constexpr std::size_t kCacheBytes = std::size_t(64) << 20;

  using TilePtr = std::shared_ptr<const TeElevationTile>;

  TeElevationTiles(std::unique_ptr<TeRasterFile> raster, const TeElevationOptions& options,
                   double metresPerStep);

  /// Posts of a tile's side: tile (i, j) has the posts from (i·side, j·side) on, fewer at the far edges.
  int side() const { return 1 << m_sideBits; }
  int sideBits() const { return m_sideBits; }
  int tilesAcross() const { return (m_info.columns - 1) / side() + 1; }
  int tilesDown() const { return (m_info.rows - 1) / side() + 1; }

  /// A tile that exists. Cost: a lock and a look-up if it is in memory, else its reading (and filling).
  TeResult<TilePtr> tile(int across, int down) const;

  /// Bytes of posts in the cache.
  std::size_t cachedBytes() const;
  const TeRasterInfo& info() const { return m_info; }
  std::shared_ptr<const TeMapProjection> projection() const { return m_raster->projection(); }

private:
  struct Entry {
    TilePtr tile;
    std::uint64_t lastUse = 0;
  };

  TeResult<TilePtr> load(int across, int down) const;
  TeStatus readHeights(TeRasterWindow window, std::vector<float>& heights) const;
  TeStatus fill(const TeElevationTile& tile, int rows, std::vector<float>& heights) const;
  void insert(std::uint64_t key, const TilePtr& tile) const;

  std::unique_ptr<TeRasterFile> m_raster;
  TeRasterInfo m_info;
  TePostDecoder m_decoder;
  bool m_terrarium;
  int m_band;
  int m_fillDistance;
  int m_sideBits;

  mutable std::mutex m_rasterMutex;
  mutable std::mutex m_cacheMutex;
  mutable std::unordered_map<std::uint64_t, Entry> m_cache;
  mutable std::uint64_t m_clock = 0;
  mutable std::size_t m_bytes = 0;
};
