#include "generators/faults/TeFaultSweep.h"

#include <algorithm>

namespace {

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

} // namespace

void TeFaultSweep::add(const TeFaultPlane& fault) {
  Knot knot{};
  knot.origin = fault.origin;
  knot.east = fault.east;
  knot.north = fault.north;
  knot.weight = fault.weight;
  knot.columnStep = floorDivide(fault.north, fault.east);
  knot.excessStep = fault.north - knot.columnStep * fault.east;
  m_knots.push_back(knot);
  if (!m_smooth) {
    m_base += std::uint64_t(fault.base);
    return;
  }
  m_base += std::uint64_t(fault.base) * std::uint64_t(TeFaultPlane::kRampFull);
  knot.origin = fault.origin - TeFaultPlane::kRampHalf;
  knot.weight = -2 * fault.weight;
  m_knots.push_back(knot);
  knot.origin = fault.origin - 2 * TeFaultPlane::kRampHalf;
  knot.weight = fault.weight;
  m_knots.push_back(knot);
}

void TeFaultSweep::setStrip(std::int64_t first, int width) {
  m_first = first;
  m_width = width;
  m_differences.assign(std::size_t(width) + 2, 0);
}

// In the array of differences entry `width` and the one after it take what falls behind the last column.
inline void TeFaultSweep::deposit(const Knot& knot) {
  if (knot.column >= m_width)
    return;
  const std::int64_t column = std::max<std::int64_t>(knot.column, 0);
  std::uint64_t* const at = m_differences.data() + column;
  if (!m_smooth) {
    at[0] += std::uint64_t(knot.weight);
    return;
  }
  // Third differences of v², (v+e)², (v+2e)² … that begin after zeros; the fourth and later ones vanish.
  const std::uint64_t weight = std::uint64_t(knot.weight);
  const std::uint64_t east = std::uint64_t(knot.east);
  const std::uint64_t v = std::uint64_t(knot.excess) + east * std::uint64_t(column - knot.column);
  const std::uint64_t square = weight * v * v;
  const std::uint64_t cross = 2 * weight * v * east;
  const std::uint64_t eastSquare = weight * east * east;
  at[0] += square;
  at[1] += cross + eastSquare - 2 * square;
  at[2] += square - cross + eastSquare;
}

void TeFaultSweep::place(std::size_t begin, std::size_t end, std::int64_t row) {
  for (std::size_t i = begin; i < end; ++i) {
    Knot& knot = m_knots[i];
    const std::int64_t value = knot.origin + knot.east * m_first + knot.north * row;
    knot.column = floorDivide(-value, knot.east) + 1;
    knot.excess = value + knot.east * knot.column;
    deposit(knot);
  }
}

void TeFaultSweep::advance(std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    Knot& knot = m_knots[i];
    knot.column -= knot.columnStep;
    knot.excess += knot.excessStep;
    if (knot.excess > knot.east) {
      knot.excess -= knot.east;
      --knot.column;
    }
    deposit(knot);
  }
}

void TeFaultSweep::finishRow(std::int64_t* sums) {
  std::uint64_t height = 0;
  if (m_smooth) {
    std::uint64_t slope = 0;
    std::uint64_t bend = 0;
    for (int c = 0; c < m_width; ++c) {
      bend += m_differences[std::size_t(c)];
      slope += bend;
      height += slope;
      sums[c] = std::int64_t(height + m_base);
    }
  } else {
    height = m_base;
    for (int c = 0; c < m_width; ++c) {
      height += m_differences[std::size_t(c)];
      sums[c] = std::int64_t(height);
    }
  }
  std::fill(m_differences.begin(), m_differences.end(), 0);
}
