#include "nodes/seamless/TeSeamlessFan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

/// Largest deviation of the samples `first` .. `last` along a row from the line start + slope·coordinate.
double lineDeviation(const TeSeamlessFan::Row& row, std::int64_t first, std::int64_t last, double start,
                     double slope) {
  double largest = 0;
  for (std::int64_t i = first; i <= last; i++)
    largest =
        std::max(largest, std::fabs(double(row.corner[row.direction * i]) - (start + slope * double(i))));
  return largest;
}

} // namespace

void TeSeamlessFan::set(int step, int finest, const double* diagonal, double apex) {
  m_step = step;
  m_finest = finest;
  m_diagonal = diagonal;
  m_apex = apex;
}

double TeSeamlessFan::deviation(const Row& row) const {
  double largest = 0;
  for (int step = m_step / 2; step >= m_finest; step /= 2)
    largest = std::max(largest, partDeviation({0, m_step, m_apex}, step, row));
  return std::max(largest, morphedDeviation(row));
}

/// A sample lies at λ·(p, p) + (1 - λ)·apex with λ = (step - v + u) / step and λ·p = u; so over the piece of
/// the diagonal from j·d to (j + 1)·d the height is (1 - λ)·A + λ·H[j] + (u - λ·j·d)·(H[j + 1] - H[j]) / d,
/// which is linear along rows. With heights of few bits all of it is exact.
double TeSeamlessFan::partDeviation(const Part& part, int diagonalStep, const Row& row) const {
  const std::int64_t size = part.step;
  const std::int64_t across = row.across - part.origin;
  if (across < 0 || across > size)
    return 0;
  Row local = row;
  local.corner += row.direction * part.origin;
  const double* heights = m_diagonal + part.origin;
  const double scale = 1.0 / double(size);
  double largest = 0;
  if (row.alongU) {
    const std::int64_t v = across;
    for (std::int64_t from = 0; from < size && from <= v; from += diagonalStep) {
      const std::int64_t to = from + diagonalStep;
      const double slope = (heights[to] - heights[from]) / diagonalStep;
      const std::int64_t first = ((size - v) * from + size - from - 1) / (size - from);
      const std::int64_t last = to == size ? v : std::min(v, (size - v) * to / (size - to));
      const double start = double(v) * part.apex + double(size - v) * (heights[from] - double(from) * slope);
      const double rise = heights[from] - part.apex + double(size - from) * slope;
      largest = std::max(largest, lineDeviation(local, first, last, start * scale, rise * scale));
    }
    return largest;
  }
  const std::int64_t u = across;
  for (std::int64_t from = u / diagonalStep * diagonalStep; from < size; from += diagonalStep) {
    const std::int64_t to = from + diagonalStep;
    const double slope = (heights[to] - heights[from]) / diagonalStep;
    const std::int64_t first = from <= u ? u : size + u - size * u / from;
    const std::int64_t last = size + u - (size * u + to - 1) / to;
    const double start = double(u) * (double(size) * slope - part.apex) +
                         double(size + u) * (heights[from] - double(from) * slope);
    const double rise = part.apex - heights[from] + double(from) * slope;
    largest = std::max(largest, lineDeviation(local, first, last, start * scale, rise * scale));
  }
  return largest;
}

/// The flank at the next higher resolution, its new vertices in the middle of the triangle's legs, and the
/// diagonal at that resolution or a higher one with its vertices at their own heights. Up to a diagonal of
/// four pieces every sample lies between what the triangle gives and what a fan gives.
double TeSeamlessFan::morphedDeviation(const Row& row) const {
  const int half = m_step / 2;
  const double before = (m_diagonal[0] + m_apex) / 2;
  const double after = (m_apex + m_diagonal[m_step]) / 2;
  double largest = 0;
  for (int step = m_step / 8; step >= m_finest; step /= 2) {
    largest = std::max(largest, partDeviation({0, half, before}, step, row));
    largest = std::max(largest, partDeviation({half, half, after}, step, row));
  }
  return largest;
}
