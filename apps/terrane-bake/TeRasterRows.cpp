#include "apps/terrane-bake/TeRasterRows.h"

#include "generators/TeHeightMap.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>
#include <limits>

TeRasterRows::TeRasterRows(std::string path, std::unique_ptr<TeRasterFile> raster, int band, int channels,
                           const TePostDecoder& decoder, std::optional<double> fill)
    : m_path(std::move(path)), m_raster(std::move(raster)), m_band(band), m_decoder(decoder),
      m_fill(fill.value_or(std::numeric_limits<double>::quiet_NaN())) {
  m_columns = m_raster->info().columns;
  m_rows = m_raster->info().rows;
  m_channels = channels;
  m_blockRows = std::clamp(kBlockNumbers / channels / m_columns, 1, m_rows);
}

TeStatus TeRasterRows::readBlock(int firstRow) {
  const int rows = std::min(m_blockRows, m_rows - firstRow);
  const std::size_t ofChannel = std::size_t(m_columns) * std::size_t(m_blockRows);
  m_block.resize(ofChannel * std::size_t(m_channels));
  m_firstRow = -1;
  for (int channel = 0; channel < m_channels; ++channel) {
    double* const numbers = m_block.data() + ofChannel * std::size_t(channel);
    if (TeStatus ok = m_raster->read(m_band + channel, {0, firstRow, m_columns, rows}, numbers); !ok)
      return TeError{m_path + ": " + ok.error().message};
    for (double* number = numbers; number != numbers + std::size_t(m_columns) * rows; ++number)
      if (m_channels == 1 && TeHeightMap::isMissing(m_decoder.height(*number)))
        *number = m_fill;
      else if (m_channels > 1 && !(*number >= 0 && *number <= 255 && *number == std::floor(*number)))
        return TeError{m_path + ": band " + std::to_string(m_band + channel) + " has a " +
                       teNumberText(*number) + ", but colours are bytes; --band takes heights from a band"};
  }
  m_firstRow = firstRow;
  return {};
}

TeStatus TeRasterRows::read(int row, double* numbers) {
  const int firstRow = row / m_blockRows * m_blockRows;
  if (firstRow != m_firstRow)
    if (TeStatus ok = readBlock(firstRow); !ok)
      return ok;
  const std::size_t ofChannel = std::size_t(m_columns) * std::size_t(m_blockRows);
  const double* const from = m_block.data() + std::size_t(row - firstRow) * std::size_t(m_columns);
  for (int channel = 0; channel < m_channels; ++channel)
    for (int column = 0; column < m_columns; ++column)
      numbers[std::size_t(column) * m_channels + channel] = from[ofChannel * channel + std::size_t(column)];
  return {};
}
