#pragma once

#include "generators/TeFilter.h"

/// The linear (band) filter: h[x] = h[x-1]·(1-k) + h[x]·k in place along whole lines of the map; one pass
/// goes along the rows rising, the rows falling, the columns rising and the columns falling (document 002).
///
/// In float, each operation rounded, with 1-k taken of k as a float; the first sample of each line stays. A
/// missing sample stays missing, and the recursion starts anew behind it. With k = 1 or no passes the filter
/// is its input. Otherwise a sample depends on its whole map: the result neither fits nor can be evaluated at
/// scattered points. Any size of at least 16 a side, thinner ones up to 2^24 samples.
///
/// Several weak passes look better than a strong one. Cost: see docs/filters.md.
class TeBandFilter final : public TeFilter {
public:
  TeBandFilter();
  std::string name() const override { return "band"; }
  TeParameters parameters() override;

  double k;   ///< 0 to 1; 1 changes nothing
  int passes; ///< 0 to 1000

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource(TeHeightSourcePtr input) const override;
};
