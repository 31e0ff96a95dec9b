#pragma once

#include "generators/faults/TeFaultPlane.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Sums faults over rows of a map from where their lines cross the row, instead of from samples.
///
/// Along a row a fault's height is a sum of *knots*: a step profile has one, 0 up to some column and constant
/// from it on; a smooth one has three, T(v) = v² from the column on where v becomes positive. In an array of
/// differences (of first and of third order) a knot is one and three entries; running sums give the row. From
/// one row to the next a crossing moves by a constant fraction of a column, kept as quotient and remainder:
/// exact, and without division. Sums wrap at 2^64, so only the result has to fit 64 bits.
class TeFaultSweep {
public:
  static constexpr int kMaxStrip = 2048; ///< columns that are swept together

  explicit TeFaultSweep(bool smooth) : m_smooth(smooth) {}

  void add(const TeFaultPlane& fault);
  std::size_t knots() const { return m_knots.size(); }

  /// Chooses the columns first .. first+width-1; each knot must then be placed anew.
  void setStrip(std::int64_t first, int width);
  /// Puts knots begin .. end-1 into a row: any row for knots not placed yet, else the next one.
  void place(std::size_t begin, std::size_t end, std::int64_t row);
  void advance(std::size_t begin, std::size_t end);
  /// Writes the sums of the present row, bases included, once all knots are in it, and clears it.
  /// sums: width entries.
  void finishRow(std::int64_t* sums);

private:
  struct Knot {
    std::int64_t origin;
    std::int64_t east;
    std::int64_t north;
    std::int64_t weight;
    std::int64_t column;     ///< first with a positive value, relative to the strip
    std::int64_t excess;     ///< the value there, 1 .. east
    std::int64_t columnStep; ///< north = columnStep·east + excessStep, 0 ≤ excessStep < east
    std::int64_t excessStep;
  };

  void deposit(const Knot& knot);

  bool m_smooth;
  std::vector<Knot> m_knots;
  std::uint64_t m_base = 0;
  std::int64_t m_first = 0;
  int m_width = 0;
  std::vector<std::uint64_t> m_differences;
};
