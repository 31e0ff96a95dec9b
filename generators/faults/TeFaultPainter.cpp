#include "generators/faults/TeFaultPainter.h"

#include <algorithm>

namespace {

constexpr std::int64_t kWorkPerUnit = 16384;
constexpr int kWorkPerCall = 4096;
constexpr int kWorkPerPlacing = 8;

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
  m_added = 0;
  m_sweep.beginBand(first, m_bandRows);
}

std::int64_t TeFaultPainter::sweep(TeHeightMap& map) {
  if (m_added < m_sweep.faults()) {
    const int workPerFault = kWorkPerPlacing + m_bandRows * (m_source->isSmooth() ? 3 : 1);
    const std::size_t count = std::size_t(std::max(1, kWorkPerCall / workPerFault));
    const std::size_t end = std::min(m_added + count, m_sweep.faults());
    m_sweep.addFaults(m_added, end);
    const std::int64_t work = std::int64_t(end - m_added) * workPerFault;
    m_added = end;
    return work;
  }
  m_sweep.finishRow(m_sums.data());
  m_source->heights(m_sums.data(), m_sums.size(), map.row(m_bandFirst + m_bandRow) + m_stripFirst);
  const std::int64_t work = m_stripWidth;
  if (++m_bandRow == m_bandRows) {
    if (m_bandFirst + m_bandRows == map.height())
      beginStrip(map, m_stripFirst + m_stripWidth);
    else
      beginBand(map, m_bandFirst + m_bandRows);
  }
  return work;
}
