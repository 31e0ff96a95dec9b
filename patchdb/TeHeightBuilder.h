#pragma once

#include "patchdb/TeFourMapBlend.h"
#include "patchdb/TeNeededMaps.h"

#include <optional>

/// Makes the heights of a patch from its source maps, in slices: by blending, or, where there is one map only
/// (TeNeededMaps), by copying its quarter.
class TeHeightBuilder {
public:
  /// All maps, or the one that is needed, are set and have (2n + 1)² samples. The weights must outlive the
  /// builder. Error: no memory for the heights.
  static TeResult<std::unique_ptr<TeHeightBuilder>> create(const TePatchMaps& maps,
                                                           const TeBlendWeights& weights);

  /// True when done. Units as of TeFourMapBlend; a copy is one unit.
  bool step(TeAllowance& allowance);
  /// Moves the heights out, once done.
  TeHeightMap take() { return std::move(m_heights); }

private:
  TeHeightBuilder() = default;

  TePatchMaps m_maps;
  TeHeightMap m_heights;
  std::optional<TeFourMapBlend> m_blend;
};
