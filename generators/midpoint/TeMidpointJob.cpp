#include "generators/midpoint/TeMidpointJob.h"

namespace {

constexpr int kSamplesPerUnit = 4096; // about 0.05 ms

} // namespace

TeMidpointJob::TeMidpointJob(std::shared_ptr<const TeMidpointDisplacement> source,
                             const TeMapRequest& request)
    : m_source(std::move(source)), m_request(request), m_random(m_source->random(request)),
      m_displacement(m_source->parameters().displacement) {}

TeProgress TeMidpointJob::unit() {
  if (m_map.empty()) {
    TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
    if (!map)
      return fail(TeError{"midpoint: " + map.error().message});
    m_map = std::move(*map);
    setCorners();
  }
  for (int left = kSamplesPerUnit; left > 0 && m_half > 0; --left) {
    if (m_pass == Pass::Centres)
      setCentre(m_x, m_y);
    else
      setEdge(m_x, m_y);
    m_x += 2 * m_half;
    if (m_x < m_map.width())
      continue;
    m_y += m_pass == Pass::Centres ? 2 * m_half : m_half;
    m_x = firstColumn(m_y);
    if (m_y < m_map.height())
      continue;
    if (m_pass == Pass::Centres) {
      beginPass(Pass::Edges);
    } else {
      m_half /= 2;
      m_displacement *= m_source->parameters().fall;
      beginPass(Pass::Centres);
    }
  }
  return m_half > 0 ? TeProgress::Working : TeProgress::Done;
}

void TeMidpointJob::setCorners() {
  const int last = m_map.width() - 1;
  for (int y : {0, last})
    for (int x : {0, last})
      store(x, y, 0.0);
  m_half = last / 2;
  beginPass(Pass::Centres);
}

int TeMidpointJob::firstColumn(int row) const {
  if (m_pass == Pass::Centres || m_half == 0)
    return m_half;
  return row / m_half % 2 == 0 ? m_half : 0;
}

void TeMidpointJob::beginPass(Pass pass) {
  m_pass = pass;
  m_y = pass == Pass::Centres ? m_half : 0;
  m_x = firstColumn(m_y);
}

void TeMidpointJob::setCentre(int x, int y) {
  const int h = m_half;
  const double sum = double(m_map.at(x - h, y - h)) + double(m_map.at(x + h, y - h)) +
                     double(m_map.at(x - h, y + h)) + double(m_map.at(x + h, y + h));
  store(x, y, sum * 0.25);
}

// The four neighbours at distance h are two ends of the edge and the centres on both sides of it.
void TeMidpointJob::setEdge(int x, int y) {
  const int h = m_half;
  const int last = m_map.width() - 1;
  const bool rim = x == 0 || x == last || y == 0 || y == last;
  double sum = 0;
  if (x > 0)
    sum += double(m_map.at(x - h, y));
  if (x < last)
    sum += double(m_map.at(x + h, y));
  if (y > 0)
    sum += double(m_map.at(x, y - h));
  if (y < last)
    sum += double(m_map.at(x, y + h));
  store(x, y, rim ? sum / 3 : sum * 0.25);
}

void TeMidpointJob::store(int x, int y, double mean) {
  const std::uint64_t sample = std::uint64_t(y) * std::uint64_t(m_map.width()) + std::uint64_t(x);
  m_map.at(x, y) = float(mean + m_displacement * m_source->displacement(m_random, sample));
}
