#include "nodes/clipmap/TeClipImage.h"

#include <algorithm>
#include <cassert>

namespace {

/// Calls piece(first, count, place) for the runs of samples that lie side by side in an image of that side.
template <class Piece>
void forEachRun(std::int32_t first, std::int32_t count, std::int32_t side, Piece piece) {
  while (count > 0) {
    const std::int32_t place = first % side;
    const std::int32_t run = std::min(count, side - place);
    piece(first, run, place);
    first += run;
    count -= run;
  }
}

} // namespace

TeClipImage::TeClipImage(int level, int side, int bytesPerSample)
    : m_level(level), m_side(side), m_bytesPerSample(bytesPerSample),
      m_samples(std::size_t(side) * std::size_t(side) * std::size_t(bytesPerSample)) {}

TeStatus TeClipImage::loadWhole(TePyramidTiles& tiles, int from) {
  const std::int32_t side = tePyramidSide(m_level);
  assert(side <= m_side && from >= m_level);
  const auto bytes = std::size_t(m_bytesPerSample);
  if (from == m_level) {
    if (TeStatus ok = tiles.read(m_level, {0, 0, side, side}, m_samples.data(), rowBytes()); !ok)
      return ok;
  } else {
    const int shift = from - m_level;
    const std::int32_t columns = tePyramidSide(from);
    std::vector<unsigned char> row(std::size_t(columns) * bytes);
    for (std::int32_t y = 0; y < side; y++) {
      if (TeStatus ok = tiles.read(from, {0, y << shift, columns, 1}, row.data(), row.size()); !ok)
        return ok;
      for (std::int32_t x = 0; x < side; x++)
        std::copy_n(&row[(std::size_t(x) << shift) * bytes], bytes,
                    &m_samples[std::size_t(y) * rowBytes() + std::size_t(x) * bytes]);
    }
  }
  m_held = {0, 0, side, side};
  return {};
}

TeResult<std::int64_t> TeClipImage::follow(TePyramidTiles& tiles, const TeSampleRect& window,
                                           std::int64_t samples, std::vector<TeSampleRect>& places) {
  assert(window.columns == m_side && window.rows == m_side);
  m_held = teIntersection(m_held, window);
  if (m_held.isEmpty()) {
    // From the middle, which stays wanted for longest while the viewer moves on.
    const bool isAll = samples >= window.count();
    m_held = {window.x, isAll ? window.y : window.y + m_side / 2, m_side, 0};
  }
  std::int64_t left = samples;
  TeStatus status;
  // As many of `wanted` lines of `line` samples as there are samples left.
  const auto affordable = [&](std::int32_t wanted, std::int32_t line) {
    return line == 0 ? 0 : std::int32_t(std::min<std::int64_t>(wanted, left / line));
  };
  const auto add = [&](const TeSampleRect& rect) {
    left -= rect.count();
    status = load(tiles, rect, places);
    return status.ok();
  };
  const auto addAll = [&] {
    const std::int32_t west = affordable(m_held.x - window.x, m_held.rows);
    if (!add({m_held.x - west, m_held.y, west, m_held.rows}))
      return;
    m_held.x -= west;
    m_held.columns += west;
    const std::int32_t east = affordable(window.x + m_side - m_held.x - m_held.columns, m_held.rows);
    if (!add({m_held.x + m_held.columns, m_held.y, east, m_held.rows}))
      return;
    m_held.columns += east;
    if (m_held.columns < m_side)
      return;
    const std::int32_t south = affordable(m_held.y - window.y, m_side);
    if (!add({m_held.x, m_held.y - south, m_side, south}))
      return;
    m_held.y -= south;
    m_held.rows += south;
    const std::int32_t north = affordable(window.y + m_side - m_held.y - m_held.rows, m_side);
    if (!add({m_held.x, m_held.y + m_held.rows, m_side, north}))
      return;
    m_held.rows += north;
  };
  addAll();
  if (status)
    return samples - left;
  m_hasFailed = true;
  m_held = {};
  return status.error();
}

TeStatus TeClipImage::load(TePyramidTiles& tiles, const TeSampleRect& rect,
                           std::vector<TeSampleRect>& places) {
  TeStatus status;
  forEachRun(rect.y, rect.rows, m_side, [&](std::int32_t y, std::int32_t rows, std::int32_t row) {
    forEachRun(rect.x, rect.columns, m_side, [&](std::int32_t x, std::int32_t columns, std::int32_t column) {
      if (!status)
        return;
      unsigned char* to = m_samples.data() + offset(column, row);
      status = tiles.read(m_level, {x, y, columns, rows}, to, rowBytes());
      if (status)
        places.push_back({column, row, columns, rows});
    });
  });
  return status;
}
