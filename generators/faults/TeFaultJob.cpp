#include "generators/faults/TeFaultJob.h"

#include <algorithm>

namespace {

// Units of about 0.1 ms.
constexpr int kFaultsPerUnit = 1024;
constexpr std::int64_t kWorkPerUnit = 16384;

} // namespace

TeFaultJob::TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request)
    : m_source(std::move(source)), m_request(request), m_sweep(m_source->isSmooth()) {}

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
    m_sweep.add(m_source->plane(m_request, m_drawn));
}

void TeFaultJob::beginStrip(int first) {
  m_stripFirst = first;
  m_stripWidth = std::min(TeFaultSweep::kMaxStrip, m_request.columns - first);
  m_row = 0;
  m_knot = 0;
  if (m_stripWidth > 0)
    m_sweep.setStrip(first, m_stripWidth);
  m_sums.resize(std::size_t(std::max(m_stripWidth, 0)));
}

std::int64_t TeFaultJob::sweep() {
  if (m_knot < m_sweep.knots()) {
    const std::size_t end = std::min<std::size_t>(m_knot + kWorkPerUnit, m_sweep.knots());
    const std::int64_t work = std::int64_t(end - m_knot);
    if (m_row == 0)
      m_sweep.place(m_knot, end, m_row);
    else
      m_sweep.advance(m_knot, end);
    m_knot = end;
    return work;
  }
  m_sweep.finishRow(m_sums.data());
  float* const heights = m_map.row(m_row) + m_stripFirst;
  for (int c = 0; c < m_stripWidth; ++c)
    heights[c] = m_source->height(m_sums[std::size_t(c)]);
  const std::int64_t work = m_stripWidth;
  ++m_row;
  m_knot = 0;
  if (m_row == m_request.rows)
    beginStrip(m_stripFirst + m_stripWidth);
  return work;
}
