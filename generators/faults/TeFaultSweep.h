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
/// exact, and without division. Sums wrap at 2^64, so only the result has to fit 64 bits.
class TeFaultSweep {
public:
  static constexpr int kMaxStrip = 2048; ///< columns
  static constexpr int kBandSamples = 8192;

  explicit TeFaultSweep(bool smooth) : m_smooth(smooth) {}

  void add(const TeFaultPlane& fault);
  std::size_t knots() const { return m_knots.size(); }

  /// Begins the strip of columns first .. first+width-1 with a band of rows that starts at row 0; returns the
  /// largest number of rows of a band, at least 1.
  int beginStrip(std::int64_t first, int width);
  /// Adds knots begin .. end-1 to all rows of the present band and moves them on to the next one.
  void addKnots(std::size_t begin, std::size_t end, int rows);
  /// Writes the sums of a row of the present band, bases included, once all knots are in it, and clears it.
  /// sums: width entries.
  void finishRow(int row, std::int64_t* sums);
  /// To be called when all rows of a band are written: the next band follows it.
  void nextBand() { m_placed = true; }

private:
  struct Knot {
    std::int64_t origin;
    std::int64_t east;
    std::int64_t weight;
    std::int64_t column;     ///< first with a positive value in the band's first row, relative to the strip
    std::int64_t excess;     ///< the value there, 1 .. east
    std::int64_t columnStep; ///< north = columnStep·east + excessStep, 0 ≤ excessStep < east
    std::int64_t excessStep;

    void nextRow() {
      column -= columnStep;
      excess += excessStep;
      const bool over = excess > east;
      column -= over ? 1 : 0;
      excess -= over ? east : 0;
    }
  };

  void addSteps(Knot& knot, int rows);
  void addParabolas(Knot& knot, int rows);

  bool m_smooth;
  std::vector<Knot> m_knots;
  std::uint64_t m_base = 0;
  std::int64_t m_first = 0;
  int m_width = 0;
  std::size_t m_stride = 0; ///< width + 2: entries for what falls behind the last column
  bool m_placed = false;    ///< knots are at the present band already
  std::vector<std::uint64_t> m_differences;
};
