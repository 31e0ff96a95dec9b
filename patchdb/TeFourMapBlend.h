#pragma once

#include "generators/TeHeightMap.h"
#include "generators/base/TeAllowance.h"

/// Blends four source maps into the heights of a patch (document 002, joining by four overlapping maps).
///
/// Maps of W×W samples, W = 2n+1, centred on the corners of the patch; the patch has (n+1)×(n+1) samples. At
/// patch sample (x, y) the south-west map has the integer weight (n-x)(n-y), the south-east one x(n-y), the
/// north-west one (n-x)y, the north-east one xy; they sum to n². The height is the sum of weight·height in
/// double, in this order, divided by n² and rounded to float once. Hence:
/// - four equal inputs come back bit for bit (every product and sum is exact);
/// - maps of weight 0 take no part, so that on a border only the two maps (at a corner the one map) count
/// that
///   the neighbour has there too, in the same order: both patches get the same bits;
/// - a sample is missing if an input of positive weight is.
/// The bits do not depend on the instruction set that is chosen at run time.
///
/// Cost: see docs/four-map-blending.md; bound by memory unless the maps are in the cache.
class TeFourMapBlend {
public:
  /// The maps must be W×W with the same odd W >= 3, the patch (n+1)×(n+1), all alive until done.
  TeFourMapBlend(const TeHeightMap& southWest, const TeHeightMap& southEast, const TeHeightMap& northWest,
                 const TeHeightMap& northEast, TeHeightMap& patch);

  /// Blends rows until the allowance is spent; a unit is about 4096 samples. True when all are done.
  bool step(TeAllowance& allowance);
  /// All that is left.
  void finish();

  /// Weight of a map (0 = south-west .. 3 = north-east) at a patch sample, out of n².
  static std::int64_t weight(int cells, int map, int x, int y);

private:
  void blendTo(int end);
  void blendBorder(int y);

  const TeHeightMap* m_maps[4];
  TeHeightMap* m_patch;
  int m_cells;
  int m_row = 0;
};
