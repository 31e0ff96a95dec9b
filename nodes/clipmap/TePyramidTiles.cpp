#include "nodes/clipmap/TePyramidTiles.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace {

std::uint64_t tileKey(int level, std::int32_t across, std::int32_t up) {
  return std::uint64_t(level) << 58 | std::uint64_t(up) << 29 | std::uint64_t(across);
}

} // namespace

TePyramidTiles::TePyramidTiles(TePyramidReader reader, std::size_t cacheBytes)
    : m_reader(std::move(reader)), m_cacheBytes(cacheBytes) {}

TeStatus TePyramidTiles::read(int level, const TeSampleRect& rect, unsigned char* samples,
                              std::size_t rowBytes) {
  if (rect.isEmpty())
    return {};
  const auto bytesPerSample = std::size_t(m_reader.bytesPerSample());
  const std::int32_t lastAcross = (rect.x + rect.columns - 1) / kTileSide;
  const std::int32_t lastUp = (rect.y + rect.rows - 1) / kTileSide;
  for (std::int32_t up = rect.y / kTileSide; up <= lastUp; up++) {
    for (std::int32_t across = rect.x / kTileSide; across <= lastAcross; across++) {
      TeStatus status;
      const Tile* from = tile(level, across, up, status);
      if (!from)
        return status;
      const std::int32_t west = std::max(rect.x, from->rect.x);
      const std::int32_t east = std::min(rect.x + rect.columns, from->rect.x + from->rect.columns);
      const std::int32_t south = std::max(rect.y, from->rect.y);
      const std::int32_t north = std::min(rect.y + rect.rows, from->rect.y + from->rect.rows);
      const std::size_t bytes = std::size_t(east - west) * bytesPerSample;
      for (std::int32_t y = south; y < north; y++) {
        const std::size_t offset = std::size_t(y - from->rect.y) * std::size_t(from->rect.columns) +
                                   std::size_t(west - from->rect.x);
        std::memcpy(samples + std::size_t(y - rect.y) * rowBytes +
                        std::size_t(west - rect.x) * bytesPerSample,
                    from->samples.data() + offset * bytesPerSample, bytes);
      }
    }
  }
  return {};
}

const TePyramidTiles::Tile* TePyramidTiles::tile(int level, std::int32_t across, std::int32_t up,
                                                 TeStatus& status) {
  const std::uint64_t key = tileKey(level, across, up);
  if (const auto found = m_byKey.find(key); found != m_byKey.end()) {
    m_statistics.hits++;
    m_tiles.splice(m_tiles.begin(), m_tiles, found->second);
    return &m_tiles.front();
  }
  m_statistics.misses++;
  const std::int32_t side = tePyramidSide(level);
  Tile made;
  made.key = key;
  made.rect.x = across * kTileSide;
  made.rect.y = up * kTileSide;
  made.rect.columns = std::min(kTileSide, side - made.rect.x);
  made.rect.rows = std::min(kTileSide, side - made.rect.y);
  const std::size_t bytes = std::size_t(made.rect.count()) * std::size_t(m_reader.bytesPerSample());
  makeRoom(bytes);
  made.samples.resize(bytes);
  status = m_reader.read(level, made.rect, made.samples.data(), bytes / std::size_t(made.rect.rows));
  if (!status)
    return nullptr;
  m_statistics.bytesRead += std::int64_t(bytes);
  m_bytes += bytes;
  m_tiles.push_front(std::move(made));
  m_byKey[key] = m_tiles.begin();
  return &m_tiles.front();
}

void TePyramidTiles::makeRoom(std::size_t bytes) {
  while (!m_tiles.empty() && m_bytes + bytes > m_cacheBytes) {
    m_bytes -= m_tiles.back().samples.size();
    m_byKey.erase(m_tiles.back().key);
    m_tiles.pop_back();
  }
}
