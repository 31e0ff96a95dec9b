#pragma once

#include "generators/TeHeightMap.h"

#include <memory>

/// Errors of the smallest right triangles of a grid of samples, many squares at a time: tiles of equal size,
/// one in each lane of a vector, mirrored so that all have the same triangles.
///
/// A tile is a square of side² cells whose south-west corner is at a multiple of `side`. Its vertices are the
/// middles of the sides and of the diagonal of every square of 2, 4 .. side cells in it, each of which lies
/// at a multiple of its size. The error of a vertex is the largest deviation of the samples that the
/// triangles whose hypotenuse it halves cover, from their planes, as far as these triangles are in the tile;
/// computed in double precision and rounded up.
///
/// Cost: about 1 ns a sample for all sizes together with AVX-512. One thread at a time.
class TeRtinTile {
public:
  /// Lanes of the widest vectors of this processor: 2, 4 or 8.
  static int mostLanes();

  /// `side`: a power of two from 2. `lanes`: 2, 4 or 8, not more than mostLanes(); 0: the most.
  explicit TeRtinTile(int side, int lanes = 0);

  /// Raises `errors`, of the size of `heights`, to those of all vertices of all tiles, 0 before.
  /// The map's sides are multiples of `side`, plus 1.
  void raiseAll(const TeHeightMap& heights, float* errors);

private:
  int m_side;
  int m_lanes;
  std::unique_ptr<unsigned char[]> m_sampleBytes;
  std::unique_ptr<unsigned char[]> m_errorBytes;
  double* m_samples; ///< lane l of sample (column, row) at (row·(side + 1) + column)·lanes + l
  float* m_errors;   ///< in the same order
};
