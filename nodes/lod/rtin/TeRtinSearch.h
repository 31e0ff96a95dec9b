#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeLodMesh.h"

/// Finds the largest deviation of the samples under large right triangles without looking at most of them.
///
/// Within a triangle no sample deviates by more than what a smaller one's corners do, plus the smaller one's
/// own error, which is known. So smaller triangles that cannot raise the largest deviation found so far are
/// left out; the search begins with the error of the dependent vertices, below which nothing matters.
class TeRtinSearch {
public:
  /// `errors`, one a sample, are given for all vertices of squares up to `least` cells a side. Both are kept.
  TeRtinSearch(const TeHeightMap& heights, float* errors, int least)
      : m_heights(heights), m_errors(errors), m_least(least) {}

  /// Raises the errors of the middles of the sides of all squares of a size to those of their triangles.
  void raiseSides(int size);
  /// The same of the middles of their diagonals.
  void raiseDiagonals(int size);

private:
  struct Plane {
    double origin; ///< at (0, 0)
    double alongX;
    double alongY;
  };
  struct Point {
    int x;
    int y;
    double deviation; ///< from the plane, absolute
  };

  void raise(int x, int y, const Point& a, const Point& b, const Point& apex);
  /// a-b is the hypotenuse, `legs` the length of a leg that lies along the axes, or 0.
  void search(const Point& a, const Point& b, const Point& apex);
  void look(const Point& a, const Point& b, const Point& apex);
  double deviation(int x, int y) const;

  const TeHeightMap& m_heights;
  float* m_errors;
  int m_least;
  Plane m_plane{};
  double m_worst = 0;
};
