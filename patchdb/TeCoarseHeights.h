#pragma once

#include "patchdb/TePatchTree.h"

/// What a coarse patch is made of.
struct TeCoarseHeights {
  TeHeightMap heights; ///< (n+1)×(n+1): every 2^level-th base sample, bit for bit (contract 3)
  float deviation = 0; ///< metres: no point of the base surface lies farther away, above or below
};

/// The heights of a patch of a level above 0, from the base patches that it covers.
///
/// Edges of the coarse surface are made of edges of the base surface, so that their distance is greatest at a
/// base sample: the deviation is the largest over all of these, exact and rounded up. Cells with a missing
/// corner have no part in it, nor have missing base samples.
/// Error: the key is not valid or of level 0; a base patch is not known or has no heights; levels so high
/// that the base patches are more than 2^24. Cost: some 10 ns a base sample.
TeResult<TeCoarseHeights> teCoarseHeights(const TeLattice& lattice, const TePatchTree& tree,
                                          const TePatchKey& key);
