#include "generators/TeFilter.h"

TeFilter::~TeFilter() = default;

TeResult<TeHeightSourcePtr> TeFilter::apply(TeHeightSourcePtr input) {
  assert(input);
  if (TeStatus ok = teCheckParameters(parameters(), name()); !ok)
    return ok.error();
  return makeSource(std::move(input));
}
