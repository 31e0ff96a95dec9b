#include "generators/faults/TeFaultSweep.h"

#include <algorithm>

namespace {

constexpr int kBandSamples = 12288; // their differences stay in a core's cache
constexpr int kMaxBandRows = 1024;

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Where a value that rises by `east` from column to column becomes positive.
struct Crossing {
  std::int64_t column;
  std::int64_t excess; ///< the value there, 1 .. east

  Crossing(std::int64_t value, std::int64_t east)
      : column(floorDivide(-value, east) + 1), excess(value + east * column) {}

  void nextRow(std::int64_t columnStep, std::int64_t excessStep, std::int64_t east) {
    column -= columnStep;
    excess += excessStep;
    const bool over = excess > east;
    column -= over ? 1 : 0;
    excess -= over ? east : 0;
  }
};

} // namespace

void TeFaultSweep::add(const TeFaultPlane& plane) {
  Fault fault{};
  fault.origin = plane.origin;
  fault.east = plane.east;
  fault.north = plane.north;
  fault.weight = plane.weight;
  fault.columnStep = floorDivide(plane.north, plane.east);
  fault.excessStep = plane.north - fault.columnStep * plane.east;
  m_faults.push_back(fault);
  m_base += std::uint64_t(plane.base) * std::uint64_t(m_smooth ? TeFaultPlane::kRampFull : 1);
}

int TeFaultSweep::beginStrip(std::int64_t first, int width) {
  m_firstColumn = first;
  m_width = width;
  m_stride = std::size_t(width) + 2;
  const int rows = std::clamp(kBandSamples / width, 1, kMaxBandRows);
  m_differences.assign(m_stride * std::size_t(rows), 0);
  m_rowDifferences.assign(std::size_t(rows) + 1, 0);
  return rows;
}

void TeFaultSweep::beginBand(std::int64_t first, int rows) {
  m_firstRow = first;
  m_rows = rows;
  m_row = 0;
  m_rowBase = m_base;
  std::fill(m_rowDifferences.begin(), m_rowDifferences.end(), 0);
}

// Where value + north·row > bound.
TeFaultSweep::Rows TeFaultSweep::rowsAbove(std::int64_t value, std::int64_t north, std::int64_t bound) const {
  const auto clamped = [this](std::int64_t row) { return int(std::clamp<std::int64_t>(row, 0, m_rows)); };
  if (north > 0)
    return {clamped(floorDivide(bound - value, north) + 1), m_rows};
  if (north < 0)
    return {0, clamped(-floorDivide(bound - value, -north))};
  return {0, value > bound ? m_rows : 0};
}

void TeFaultSweep::addFaults(std::size_t begin, std::size_t end) {
  constexpr std::int64_t kHalf = TeFaultPlane::kRampHalf;
  for (std::size_t i = begin; i < end; ++i) {
    const Fault& fault = m_faults[i];
    const std::int64_t value = fault.origin + fault.east * m_firstColumn + fault.north * m_firstRow;
    const Rows some = rowsAbove(value + fault.east * (m_width - 1), fault.north, 0);
    const Rows full = rowsAbove(value, fault.north, m_smooth ? 2 * kHalf - 1 : 0);
    const std::uint64_t height =
        std::uint64_t(fault.weight) * std::uint64_t(m_smooth ? TeFaultPlane::kRampFull : 1);
    m_rowDifferences[std::size_t(full.begin)] += height;
    m_rowDifferences[std::size_t(std::max(full.begin, full.end))] -= height;
    // Rows that are raised in part; `full` is a part of `some` at the same end of the band.
    const Rows part = fault.north > 0 ? Rows{some.begin, full.begin} : Rows{full.end, some.end};
    if (m_smooth) {
      addParabolas(fault, value, fault.weight, part);
      addParabolas(fault, value - kHalf, -2 * fault.weight, part);
      addParabolas(fault, value - 2 * kHalf, fault.weight, part);
    } else {
      addSteps(fault, value, part);
    }
  }
}

void TeFaultSweep::addSteps(const Fault& fault, std::int64_t value, Rows rows) {
  if (rows.begin >= rows.end)
    return;
  const std::int64_t east = fault.east;
  const std::int64_t columnStep = fault.columnStep;
  const std::int64_t excessStep = fault.excessStep;
  const std::uint64_t weight = std::uint64_t(fault.weight);
  const std::size_t stride = m_stride;
  Crossing at(value + fault.north * rows.begin, east);
  std::uint64_t* row = m_differences.data() + stride * std::size_t(rows.begin);
  for (int r = rows.begin; r < rows.end; ++r, row += stride) {
    row[at.column] += weight; // a row in part: the crossing is inside
    at.nextRow(columnStep, excessStep, east);
  }
}

void TeFaultSweep::addParabolas(const Fault& fault, std::int64_t value, std::int64_t knotWeight, Rows rows) {
  if (rows.begin >= rows.end)
    return;
  const std::int64_t east = fault.east;
  const std::int64_t columnStep = fault.columnStep;
  const std::int64_t excessStep = fault.excessStep;
  const std::int64_t width = m_width;
  const std::size_t stride = m_stride;
  const std::uint64_t weight = std::uint64_t(knotWeight);
  const std::uint64_t twiceEast = 2 * weight * std::uint64_t(east);
  const std::uint64_t eastSquare = weight * std::uint64_t(east) * std::uint64_t(east);
  Crossing at(value + fault.north * rows.begin, east);
  std::uint64_t* row = m_differences.data() + stride * std::size_t(rows.begin);
  for (int r = rows.begin; r < rows.end; ++r, row += stride) {
    if (at.column < width) {
      // Third differences of v², (v+e)², (v+2e)² … that begin after zeros; from the fourth on they vanish.
      const std::int64_t column = std::max<std::int64_t>(at.column, 0);
      const std::uint64_t v = std::uint64_t(at.excess + east * (column - at.column));
      const std::uint64_t square = weight * (v * v);
      const std::uint64_t rest = eastSquare - square + twiceEast * v; // (v+e)² - 2·v²
      row[column] += square;
      row[column + 1] += rest - square;
      row[column + 2] += 2 * eastSquare - rest;
    }
    at.nextRow(columnStep, excessStep, east);
  }
}

void TeFaultSweep::finishRow(std::int64_t* sums) {
  std::uint64_t* const differences = m_differences.data() + m_stride * std::size_t(m_row);
  m_rowBase += m_rowDifferences[std::size_t(m_row)];
  ++m_row;
  const int width = m_width;
  std::uint64_t height = m_rowBase;
  if (m_smooth) {
    std::uint64_t slope = 0;
    std::uint64_t bend = 0;
    for (int c = 0; c < width; ++c) {
      bend += differences[c];
      slope += bend;
      height += slope;
      sums[c] = std::int64_t(height);
    }
  } else {
    for (int c = 0; c < width; ++c) {
      height += differences[c];
      sums[c] = std::int64_t(height);
    }
  }
  std::fill(differences, differences + m_stride, 0);
}
