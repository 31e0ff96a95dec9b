#include "generators/faults/TeFaultJob.h"

#include <algorithm>

namespace {

constexpr int kFaultsPerUnit = 1024; // about 0.05 ms

} // namespace

TeFaultJob::TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request)
    : m_source(std::move(source)), m_request(request), m_random(m_source->random(request)),
      m_painter(*m_source) {}

TeProgress TeFaultJob::unit() {
  if (m_map.empty()) {
    TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
    if (!map)
      return fail(TeError{"faults: " + map.error().message});
    m_map = std::move(*map);
  }
  if (m_drawn < m_source->faults()) {
    const int end = std::min(m_drawn + kFaultsPerUnit, m_source->faults());
    for (; m_drawn < end; ++m_drawn)
      m_painter.add(m_source->plane(m_request, m_random, m_drawn));
    return TeProgress::Working;
  }
  return m_painter.paint(m_map) ? TeProgress::Done : TeProgress::Working;
}
