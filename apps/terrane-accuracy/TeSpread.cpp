#include "apps/terrane-accuracy/TeSpread.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

/// Of sorted values, between neighbours in proportion.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * double(sorted.size() - 1);
  const std::size_t below = std::size_t(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - double(below)) * (sorted[above] - sorted[below]);
}

} // namespace

TeSpread TeSpread::of(std::vector<double> values) {
  if (values.empty())
    return {};
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75), sum / double(values.size())};
}
