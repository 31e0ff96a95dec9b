#pragma once

#include "generators/faults/TeFaultPlane.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Sums faults over the rows of a strip of a map from where their lines cross the rows, instead of from
/// samples.
///
/// Along a row a fault's height is a sum of *knots*: a step profile has one, 0 up to some column and constant
/// from it on; a smooth one has three, T(v) = v² from the column on where v becomes positive. In an array of
/// differences (of first and of third order) a knot is one and three entries; running sums give the row. From
/// one row to the next a crossing moves by a constant fraction of a column, kept as quotient and remainder:
/// exact, and without division. Rows that lie wholly on one side of a fault cost nothing: two entries in
/// differences from row to row. Sums wrap at 2^64, so only the result has to fit 64 bits.
class TeFaultSweep {
public:
  static constexpr int kMaxStrip = 2048; ///< columns

  explicit TeFaultSweep(bool smooth) : m_smooth(smooth) {}

  void add(const TeFaultPlane& fault);
  std::size_t faults() const { return m_faults.size(); }

  /// Chooses the columns first .. first+width-1; returns the largest number of rows of a band, at least 1.
  int beginStrip(std::int64_t first, int width);
  /// Begins the band of rows first .. first+rows-1; that before must be finished.
  void beginBand(std::int64_t first, int rows);
  /// Adds faults begin .. end-1 to the band.
  void addFaults(std::size_t begin, std::size_t end);
  /// Writes the sums of the next row of the band, bases included, once all faults are in it: width entries.
  void finishRow(std::int64_t* sums);

private:
  struct Fault {
    std::int64_t origin;
    std::int64_t east;
    std::int64_t north;
    std::int64_t weight;
    std::int64_t columnStep; ///< north = columnStep·east + excessStep, 0 ≤ excessStep < east
    std::int64_t excessStep;
  };
  /// Rows begin .. end-1 of the band.
  struct Rows {
    int begin;
    int end;
  };

  Rows rowsAbove(std::int64_t value, std::int64_t north, std::int64_t bound) const;
  void addSteps(const Fault& fault, std::int64_t value, Rows rows);
  void addParabolas(const Fault& fault, std::int64_t value, std::int64_t weight, Rows rows);

  bool m_smooth;
  std::vector<Fault> m_faults;
  std::uint64_t m_base = 0;
  std::int64_t m_firstColumn = 0;
  std::int64_t m_firstRow = 0;
  int m_width = 0;
  int m_rows = 0;
  int m_row = 0;                               ///< of the band, next to be finished
  std::size_t m_stride = 0;                    ///< width + 2: entries for what falls behind the last column
  std::uint64_t m_rowBase = 0;                 ///< sum of m_rowDifferences up to the row before
  std::vector<std::uint64_t> m_differences;    ///< rows of m_stride entries
  std::vector<std::uint64_t> m_rowDifferences; ///< of what is the same all along a row
};
