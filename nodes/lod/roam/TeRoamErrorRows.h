#pragma once

#include "generators/TeHeightMap.h"

#include <cstdint>
#include <vector>

/// Exact errors of the triangles of one level of a triangle quadtree: the largest deviation of the samples
/// that a triangle covers from any surface that may be drawn in its place (TeRoamFan), but for parts of that
/// which are triangles of deeper levels. In the unit of the samples, in double precision, rounded up.
///
/// There are ten such parts: the triangle, the six halves and three quarters. Small ones are measured for a
/// whole row of squares at once, a vector of squares for each sample and part; large ones one by one.
///
/// Cost: 2 to 4 ns a sample and level.
class TeRoamErrorRows {
public:
  /// `side`: cells of a square, a power of two from 4 on that divides the map's. `heights` must outlive this.
  TeRoamErrorRows(const TeHeightMap& heights, int side);

  int squares() const { return m_squares; } ///< a side
  /// Of all squares of a row of them: errors of lower and upper triangles, squares() each.
  void measure(int row, float* lower, float* upper);

private:
  /// A sample in a part, and the part's plane there: the sum of weights times corners.
  struct Term {
    int sample = 0; ///< places in a square: row·(side + 1) + column
    int corners[3] = {0, 0, 0};
    double weights[3] = {0, 0, 0};
  };

  void addTerms(bool upper, std::vector<Term>& terms) const;
  void gather(int row);
  void measureAtOnce(const std::vector<Term>& terms, float* errors);
  void measureEach(int row, bool upper, float* errors) const;

  const TeHeightMap* m_heights;
  int m_side;
  int m_squares;
  std::vector<Term> m_terms[2]; ///< of lower and upper triangles; empty: one by one
  std::vector<float> m_samples; ///< by place in the square, then square
  std::vector<double> m_worst;  ///< by square
};
