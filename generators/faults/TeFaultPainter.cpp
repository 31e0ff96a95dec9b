#include "generators/faults/TeFaultPainter.h"

#include <algorithm>

namespace {

constexpr std::int64_t kWorkPerUnit = 16384;
constexpr std::int64_t kKnotRowsPerCall = 4096;

} // namespace

bool TeFaultPainter::paint(TeHeightMap& map) {
  if (m_stripFirst < 0)
    beginStrip(map, 0);
  std::int64_t work = 0;
  while (work < kWorkPerUnit && m_stripFirst < map.width())
    work += sweep(map);
  return m_stripFirst == map.width();
}

void TeFaultPainter::beginStrip(const TeHeightMap& map, int first) {
  m_stripFirst = first;
  m_stripWidth = std::min(TeFaultSweep::kMaxStrip, map.width() - first);
  if (m_stripWidth == 0)
    return;
  m_maxBandRows = m_sweep.beginStrip(first, m_stripWidth);
  m_sums.resize(std::size_t(m_stripWidth));
  beginBand(map, 0);
}

void TeFaultPainter::beginBand(const TeHeightMap& map, int first) {
  m_bandFirst = first;
  m_bandRows = std::min(m_maxBandRows, map.height() - first);
  m_bandRow = 0;
  m_knot = 0;
}

std::int64_t TeFaultPainter::sweep(TeHeightMap& map) {
  if (m_knot < m_sweep.knots()) {
    const std::size_t count = std::size_t(std::max<std::int64_t>(1, kKnotRowsPerCall / m_bandRows));
    const std::size_t end = std::min(m_knot + count, m_sweep.knots());
    m_sweep.addKnots(m_knot, end, m_bandRows);
    const std::int64_t work = std::int64_t(end - m_knot) * m_bandRows;
    m_knot = end;
    return work;
  }
  m_sweep.finishRow(m_bandRow, m_sums.data());
  m_source->heights(m_sums.data(), m_sums.size(), map.row(m_bandFirst + m_bandRow) + m_stripFirst);
  const std::int64_t work = m_stripWidth;
  if (++m_bandRow == m_bandRows) {
    m_sweep.nextBand();
    if (m_bandFirst + m_bandRows == map.height())
      beginStrip(map, m_stripFirst + m_stripWidth);
    else
      beginBand(map, m_bandFirst + m_bandRows);
  }
  return work;
}
