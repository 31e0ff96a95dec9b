#include "nodes/seamless/TeSeamlessCellRow.h"

#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kLanes = 8;

struct Columns {
  const double* south;
  const double* north;
  const double* lowerSlope;
  const double* upperSlope;
  const double* turn;
};

inline double deviationAt(const Columns& columns, const float* samples, double below, double above, int x) {
  const double lower = columns.south[x] + below * columns.lowerSlope[x];
  const double upper = columns.north[x] - above * columns.upperSlope[x];
  return std::fabs(double(samples[x]) - (below <= columns.turn[x] ? lower : upper));
}

/// `below`, `above`: distances to the southern and the northern border.
TE_TARGET_CLONES
double largestDeviation(const Columns& columns, const float* samples, double below, double above, int first,
                        int end) {
  double lanes[kLanes] = {};
  int x = first;
  for (; x + kLanes <= end; x += kLanes)
    for (int lane = 0; lane < kLanes; lane++) {
      const double deviation = deviationAt(columns, samples, below, above, x + lane);
      lanes[lane] = deviation > lanes[lane] ? deviation : lanes[lane];
    }
  double largest = *std::max_element(lanes, lanes + kLanes);
  for (; x < end; x++)
    largest = std::max(largest, deviationAt(columns, samples, below, above, x));
  return largest;
}

} // namespace

void TeSeamlessCellRow::set(const float* south, const float* north, std::ptrdiff_t stride, int size, int step,
                            bool southern) {
  m_step = step;
  for (std::vector<double>* column : {&m_south, &m_north, &m_lowerSlope, &m_upperSlope, &m_turn})
    column->resize(std::size_t(size) + 1);
  const double part = 1.0 / step;
  for (int x = 0; x < size; x += step) {
    const double southWest = *south, northWest = *north;
    south += stride;
    north += stride;
    const double southSlope = (double(*south) - southWest) * part;
    const double northSlope = (double(*north) - northWest) * part;
    const double westSlope = (northWest - southWest) * part;
    const double eastSlope = (double(*north) - double(*south)) * part;
    const bool rising = (x < size / 2) == southern; // to the north-east
    const double lowerSlope = rising ? eastSlope : westSlope;
    const double upperSlope = rising ? westSlope : eastSlope;
    const double turnStart = rising ? 0 : step;
    const double turnSlope = rising ? 1 : -1;
    // With the last column of the cell, which the next cell sets again to the same surface.
    for (int i = 0; i <= step; i++) {
      const std::size_t column = std::size_t(x + i);
      m_south[column] = southWest + i * southSlope;
      m_north[column] = northWest + i * northSlope;
      m_lowerSlope[column] = lowerSlope;
      m_upperSlope[column] = upperSlope;
      m_turn[column] = turnStart + i * turnSlope;
    }
  }
}

double TeSeamlessCellRow::deviation(const float* samples, int y, int first, int last) const {
  const Columns columns{m_south.data(), m_north.data(), m_lowerSlope.data(), m_upperSlope.data(),
                        m_turn.data()};
  return largestDeviation(columns, samples, y, m_step - y, first, last + 1);
}
