#include "generators/elevation/TeElevationScan.h"

TeProgress TeElevationScan::step(TeAllowance& allowance) {
  if (m_progress != TeProgress::Working)
    return m_progress;
  do {
    m_progress = unit();
  } while (allowance.spend() && m_progress == TeProgress::Working);
  return m_progress;
}

TeProgress TeElevationScan::unit() {
  const std::int64_t posts = std::int64_t(m_file->columns()) * m_file->rows();
  if (posts > kMaxPosts) {
    m_error = TeError{m_file->path() + ": " + std::to_string(posts) + " posts, but at most " +
                      std::to_string(kMaxPosts) + " are searched for the highest"};
    return TeProgress::Failed;
  }
  const TeElevationTiles& tiles = m_file->tiles();
  const TeResult<TeElevationTiles::TilePtr> tile = tiles.tile(m_across, m_down);
  if (!tile) {
    m_error = TeError{m_file->path() + ": " + tile.error().message};
    return TeProgress::Failed;
  }
  add(**tile);
  if (++m_across == tiles.tilesAcross()) {
    m_across = 0;
    ++m_down;
  }
  return m_down == tiles.tilesDown() ? TeProgress::Done : TeProgress::Working;
}

void TeElevationScan::add(const TeElevationTile& tile) {
  for (std::size_t i = 0; i < tile.heights.size(); ++i) {
    const float height = tile.heights[i];
    if (TeHeightMap::isMissing(height)) {
      ++m_summary.missing;
      continue;
    }
    const int column = tile.column + int(i % std::size_t(tile.columns));
    const int row = tile.row + int(i / std::size_t(tile.columns));
    const bool first = m_summary.present++ == 0;
    if (first || height < m_summary.minimum)
      m_summary.minimum = height;
    const bool before =
        row < m_summary.highestRow || (row == m_summary.highestRow && column < m_summary.highestColumn);
    if (first || height > m_summary.maximum || (height == m_summary.maximum && before)) {
      m_summary.maximum = height;
      m_summary.highestColumn = column;
      m_summary.highestRow = row;
    }
  }
}

TeResult<TeElevationSummary> TeElevationScan::summarise(TeElevationFilePtr file) {
  TeElevationScan scan(std::move(file));
  TeAllowance all = TeAllowance::unlimited();
  if (scan.step(all) == TeProgress::Failed)
    return scan.error();
  return scan.summary();
}
