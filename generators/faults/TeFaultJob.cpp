#include "generators/faults/TeFaultJob.h"

#include <algorithm>

namespace {

// Units of about 0.1 ms.
constexpr int kFaultsPerUnit = 1024;
constexpr std::int64_t kWorkPerUnit = 16384;

} // namespace

TeFaultJob::TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request)
    : m_source(std::move(source)), m_request(request), m_random(m_source->random(request)),
      m_sweep(m_source->isSmooth()) {}

TeProgress TeFaultJob::unit() {
  if (m_map.empty()) {
    TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
    if (!map)
      return fail(TeError{"faults: " + map.error().message});
    m_map = std::move(*map);
    beginStrip(0);
  }
  if (m_drawn < m_source->faults()) {
    drawFaults();
    return TeProgress::Working;
  }
  std::int64_t work = 0;
  while (work < kWorkPerUnit && m_stripFirst < m_request.columns)
    work += sweep();
  return m_stripFirst < m_request.columns ? TeProgress::Working : TeProgress::Done;
}

void TeFaultJob::drawFaults() {
  const int end = std::min(m_drawn + kFaultsPerUnit, m_source->faults());
  for (; m_drawn < end; ++m_drawn)
    m_sweep.add(m_source->plane(m_request, m_random, m_drawn));
}

void TeFaultJob::beginStrip(int first) {
  m_stripFirst = first;
  m_stripWidth = std::min(TeFaultSweep::kMaxStrip, m_request.columns - first);
  if (m_stripWidth == 0)
    return;
  m_maxBandRows = m_sweep.beginStrip(first, m_stripWidth);
  m_sums.resize(std::size_t(m_stripWidth));
  beginBand(0);
}

void TeFaultJob::beginBand(int first) {
  m_bandFirst = first;
  m_bandRows = std::min(m_maxBandRows, m_request.rows - first);
  m_bandRow = 0;
  m_knot = 0;
}

std::int64_t TeFaultJob::sweep() {
  if (m_knot < m_sweep.knots()) {
    const std::size_t count = std::size_t(std::max<std::int64_t>(1, kWorkPerUnit / 4 / m_bandRows));
    const std::size_t end = std::min(m_knot + count, m_sweep.knots());
    m_sweep.addKnots(m_knot, end, m_bandRows);
    const std::int64_t work = std::int64_t(end - m_knot) * m_bandRows;
    m_knot = end;
    return work;
  }
  m_sweep.finishRow(m_bandRow, m_sums.data());
  float* const heights = m_map.row(m_bandFirst + m_bandRow) + m_stripFirst;
  m_source->heights(m_sums.data(), std::size_t(m_stripWidth), heights);
  const std::int64_t work = m_stripWidth;
  if (++m_bandRow == m_bandRows) {
    m_sweep.nextBand();
    if (m_bandFirst + m_bandRows == m_request.rows)
      beginStrip(m_stripFirst + m_stripWidth);
    else
      beginBand(m_bandFirst + m_bandRows);
  }
  return work;
}
