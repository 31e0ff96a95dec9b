#pragma once

#include "nodes/clipmap/TePyramidReader.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <unordered_map>
#include <vector>

/// Samples of a pyramid read in square tiles and kept in a bounded cache, of which those go first that have
/// not been used for longest: so the main memory that a pyramid takes does not depend on its size. Not
/// thread-safe.
class TePyramidTiles {
public:
  static constexpr int kTileSide = 128;
  static constexpr std::size_t kDefaultCacheBytes = std::size_t(16) << 20;

  struct Statistics {
    std::int64_t hits = 0;
    std::int64_t misses = 0;
    std::int64_t bytesRead = 0;
  };

  /// The cache holds one tile at least, whatever `cacheBytes`.
  TePyramidTiles(TePyramidReader reader, std::size_t cacheBytes);
  TePyramidTiles(const TePyramidTiles&) = delete;
  TePyramidTiles& operator=(const TePyramidTiles&) = delete;

  const TePyramidReader& reader() const { return m_reader; }
  int bytesPerSample() const { return m_reader.bytesPerSample(); }

  /// As TePyramidReader::read(). Cost: copying, a look-up a tile, and the reading of tiles that are not held,
  /// kTileSide positioned reads each.
  TeStatus read(int level, const TeSampleRect& rect, unsigned char* samples, std::size_t rowBytes);

  const Statistics& statistics() const { return m_statistics; }
  std::size_t bytesHeld() const { return m_bytes; }

private:
  struct Tile {
    std::uint64_t key = 0;
    TeSampleRect rect;
    std::vector<unsigned char> samples;
  };

  /// Valid until the next call; null after an error.
  const Tile* tile(int level, std::int32_t across, std::int32_t up, TeStatus& status);
  void makeRoom(std::size_t bytes);

  TePyramidReader m_reader;
  std::size_t m_cacheBytes;
  std::list<Tile> m_tiles; ///< the last used one first
  std::unordered_map<std::uint64_t, std::list<Tile>::iterator> m_byKey;
  std::size_t m_bytes = 0;
  Statistics m_statistics;
};
