#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string_view>
#include <vector>

/// The coefficients of a matrix filter: an odd number of rows of as many columns.
///
/// Row 1 stands for the sample's southern neighbours (z offset -radius; here y), the middle row for its own
/// row, column 1 for the western ones: in a 3×3 matrix m21 belongs to the western neighbour, m22 to the
/// sample itself. The filtered height is the sum of coefficient × height over the samples at hand, divided by
/// the sum of their coefficients.
class TeMatrix {
public:
  static constexpr int kMaxSide = 31;

  /// All coefficients equal.
  static TeResult<TeMatrix> box(int side);
  /// Binomial coefficients, the usual stand-in for a Gaussian of variance (side-1)/4.
  static TeResult<TeMatrix> gauss(int side);
  /// side² numbers, row after row, separated by blanks. Error: not numbers, not finite, or not an odd number
  /// squared of them.
  static TeResult<TeMatrix> parse(std::string_view text);

  /// Error: the matrix, or with `cutAtBorders` some part of it that remains at a border, has coefficients
  /// that cancel out.
  TeStatus checkSums(bool cutAtBorders) const;

  int side() const { return m_side; }
  int radius() const { return m_side / 2; }
  /// Offsets from -radius to radius.
  double at(int dx, int dy) const { return m_values[std::size_t((dy + radius()) * m_side + dx + radius())]; }
  const std::vector<double>& values() const { return m_values; }

  /// A sum of coefficients that no more than rounding keeps from zero.
  bool cancelsOut(double sum) const;

private:
  TeMatrix(int side, std::vector<double> values);

  int m_side;
  std::vector<double> m_values;
  double m_sizeSum; ///< of the coefficients' absolute values
};
