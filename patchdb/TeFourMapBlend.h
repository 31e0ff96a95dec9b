#pragma once

#include "generators/TeHeightMap.h"
#include "generators/base/TeAllowance.h"
#include "patchdb/TeBlendWeights.h"

/// Blends four source maps into the heights of a patch (document 002, joining by four overlapping maps).
///
/// Maps of W×W samples, W = 2n+1, centred on the corners of the patch; the patch has (n+1)×(n+1) samples.
/// The height is the sum of weight·height (TeBlendWeights) over the south-west, south-east, north-west and
/// north-east map in double, in this order, divided by the sum of the weights and rounded to float once.
/// Hence:
/// - four equal inputs come back bit for bit (every product and sum is exact);
/// - maps of weight 0 take no part, so that on a border only those two maps count (at a corner the one map)
///   that the neighbour has there too, in the same order: both patches get the same bits;
/// - a sample is missing if an input of positive weight is.
/// The bits do not depend on the instruction set that is chosen at run time.
///
/// Cost: see docs/four-map-blending.md; bound by memory unless the maps are in the cache.
class TeFourMapBlend {
public:
  /// The weights are for n cells, the maps W×W with the same odd W >= 3, the patch (n+1)×(n+1); all must live
  /// until done.
  TeFourMapBlend(const TeBlendWeights& weights, const TeHeightMap& southWest, const TeHeightMap& southEast,
                 const TeHeightMap& northWest, const TeHeightMap& northEast, TeHeightMap& patch);

  /// Blends rows until the allowance is spent; a unit is about 4096 samples. True when all are done.
  bool step(TeAllowance& allowance);
  /// All that is left.
  void finish();

private:
  void blendTo(int end);
  void blendBorder(int y);

  float blendTwo(float first, float second, int at) const;

  const TeBlendWeights* m_weights;
  const TeHeightMap* m_maps[4];
  TeHeightMap* m_patch;
  int m_cells;
  int m_row = 0;
};
