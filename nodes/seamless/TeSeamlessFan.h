#pragma once

#include <vector>

/// What can be drawn of a half strip between two of its flank's vertices where the strip's other half is
/// finer, or where the flank is morphed: a right triangle with the corners (0, 0) and (step, step) on the
/// patch's diagonal and the apex (0, step) on the flank. Coordinates (u, v) count samples from the corner
/// that is nearer to the patch's centre, v outward to the side that the half strip belongs to.
class TeSeamlessFan {
public:
  /// Heights at (t, t) in diagonal[t], t a multiple of `finest`, the distance of vertices at the highest
  /// resolution. `diagonal` must stay as long as this is used.
  void set(int step, int finest, const double* diagonal, double apex);

  /// A row of samples, in memory from west to east. It lies along u or along v.
  struct Row {
    const float* corner = nullptr; ///< where the coordinate along the row is 0
    int direction = 1;             ///< 1 if that coordinate grows eastward, else -1
    int across = 0;                ///< the other coordinate
    bool alongU = true;
  };
  /// Largest deviation of the row's samples in the triangle over all that can be drawn, but for the triangle
  /// itself.
  double deviation(const Row& row) const;

private:
  /// Part of the fan from an apex over the diagonal from (origin, origin) on.
  struct Part {
    int origin = 0;
    int step = 1;
    double apex = 0;
  };
  double partDeviation(const Part& part, int diagonalStep, const Row& row) const;
  double morphedDeviation(const Row& row) const;

  int m_step = 1;
  int m_finest = 1;
  const double* m_diagonal = nullptr;
  double m_apex = 0;
};
