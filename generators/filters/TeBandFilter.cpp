#include "generators/filters/TeBandFilter.h"

#include "generators/filters/TeBandSource.h"

TeBandFilter::TeBandFilter() { setDefaults(); }

void TeBandFilter::setDefaults() {
  k = 0.9;
  passes = 5;
}

TeParameters TeBandFilter::parameters() {
  return {
      {"k", &k, 0, 1, {}, "share of a sample's own height; the rest is its neighbour's; 1 changes nothing"},
      {"passes", &passes, 0, 1000, {}, "passes over rows and columns, both ways"}};
}

TeResult<TeHeightSourcePtr> TeBandFilter::makeSource(TeHeightSourcePtr input) const {
  if (float(k) == 1.0f || passes == 0)
    return input;
  return TeHeightSourcePtr(std::make_shared<TeBandSource>(std::move(input), float(k), passes));
}
