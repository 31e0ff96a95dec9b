#include "generators/circles/TeCirclesJob.h"

#include <algorithm>
#include <cmath>

namespace {

// Units of about 0.05 ms.
constexpr int kWorkPerUnit = 16384;
constexpr int kWorkPerRow = 16;
constexpr int kWorkPerCircle = 32;

/// The part of the samples first .. last that is in a map's side, as [begin, end).
struct Range {
  int begin;
  int end;
};

Range clipped(double first, double last, int side) {
  const double begin = std::clamp(std::ceil(first), 0.0, double(side));
  const double end = std::clamp(std::floor(last) + 1, begin, double(side));
  return {int(begin), int(end)};
}

} // namespace

TeCirclesJob::TeCirclesJob(std::shared_ptr<const TeCircles> source, const TeMapRequest& request)
    : m_source(std::move(source)), m_request(request), m_random(m_source->random(request)) {}

TeProgress TeCirclesJob::unit() {
  if (m_map.empty()) {
    TeResult<TeHeightMap> map = TeHeightMap::create(m_request.columns, m_request.rows);
    if (!map)
      return fail(TeError{"circles: " + map.error().message});
    m_map = std::move(*map);
  }
  int work = 0;
  while (work < kWorkPerUnit) {
    if (m_row < m_endRow) {
      work += kWorkPerRow + addRow(m_row++);
    } else if (m_index < m_source->parameters().circles) {
      nextCircle();
      work += kWorkPerCircle;
    } else {
      return TeProgress::Done;
    }
  }
  return TeProgress::Working;
}

void TeCirclesJob::nextCircle() {
  m_circle = m_source->circle(m_request, m_random, m_index++);
  const double y = double(m_circle.row) + double(m_circle.northward);
  const Range rows = clipped(y - m_circle.radius, y + m_circle.radius, m_request.rows);
  m_row = rows.begin;
  m_endRow = rows.end;
}

int TeCirclesJob::addRow(int row) {
  const double dy = double(row) - double(m_circle.row) - double(m_circle.northward);
  // A sample more on both sides than the chord: outside, the hill is exactly 0.
  const double chord = std::sqrt(std::max(0.0, m_circle.radius * m_circle.radius - dy * dy));
  const double x = double(m_circle.column) + double(m_circle.eastward);
  const Range columns = clipped(x - chord - 1, x + chord + 1, m_request.columns);
  const int count = columns.end - columns.begin;
  m_circle.addToRun(columns.begin, row, count, m_map.row(row) + columns.begin);
  return count;
}
