#include "generators/faults/TeFaultSweep.h"

#include <algorithm>

namespace {

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

} // namespace

void TeFaultSweep::add(const TeFaultPlane& fault) {
  Knot knot{};
  knot.origin = fault.origin;
  knot.east = fault.east;
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

int TeFaultSweep::beginStrip(std::int64_t first, int width) {
  m_first = first;
  m_width = width;
  m_stride = std::size_t(width) + 2;
  m_placed = false;
  const int rows = std::max(1, kBandSamples / width);
  m_differences.assign(m_stride * std::size_t(rows), 0);
  return rows;
}

void TeFaultSweep::addKnots(std::size_t begin, std::size_t end, int rows) {
  for (std::size_t i = begin; i < end; ++i) {
    Knot& knot = m_knots[i];
    if (!m_placed) {
      const std::int64_t value = knot.origin + knot.east * m_first;
      knot.column = floorDivide(-value, knot.east) + 1;
      knot.excess = value + knot.east * knot.column;
    }
    if (m_smooth)
      addParabolas(knot, rows);
    else
      addSteps(knot, rows);
  }
}

void TeFaultSweep::addSteps(Knot& stored, int rows) {
  Knot knot = stored;
  const std::int64_t width = m_width;
  std::uint64_t* row = m_differences.data();
  for (int r = 0; r < rows; ++r, row += m_stride) {
    row[std::clamp<std::int64_t>(knot.column, 0, width)] += std::uint64_t(knot.weight);
    knot.nextRow();
  }
  stored = knot;
}

void TeFaultSweep::addParabolas(Knot& stored, int rows) {
  Knot knot = stored;
  const std::int64_t width = m_width;
  const std::uint64_t weight = std::uint64_t(knot.weight);
  const std::uint64_t east = std::uint64_t(knot.east);
  const std::uint64_t eastSquare = weight * east * east;
  std::uint64_t* row = m_differences.data();
  for (int r = 0; r < rows; ++r, row += m_stride) {
    if (knot.column < width) {
      // Third differences of v², (v+e)², (v+2e)² … that begin after zeros; from the fourth on they vanish.
      const std::int64_t column = std::max<std::int64_t>(knot.column, 0);
      const std::uint64_t v = std::uint64_t(knot.excess) + east * std::uint64_t(column - knot.column);
      const std::uint64_t square = weight * v * v;
      const std::uint64_t cross = 2 * weight * v * east;
      row[column] += square;
      row[column + 1] += cross + eastSquare - 2 * square;
      row[column + 2] += square - cross + eastSquare;
    }
    knot.nextRow();
  }
  stored = knot;
}

void TeFaultSweep::finishRow(int row, std::int64_t* sums) {
  std::uint64_t* const differences = m_differences.data() + m_stride * std::size_t(row);
  const int width = m_width;
  const std::uint64_t base = m_base;
  std::uint64_t height = 0;
  std::uint64_t slope = 0;
  std::uint64_t bend = 0;
  if (m_smooth) {
    for (int c = 0; c < width; ++c) {
      bend += differences[c];
      slope += bend;
      height += slope;
      sums[c] = std::int64_t(height + base);
    }
  } else {
    for (int c = 0; c < width; ++c) {
      height += differences[c];
      sums[c] = std::int64_t(height + base);
    }
  }
  std::fill(differences, differences + m_stride, 0);
}
