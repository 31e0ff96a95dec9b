#include "apps/terrane-bake/TeHeightCode.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr double kMost = 65535;

}

std::uint16_t TeHeightCode::of(double number) const {
  return std::uint16_t(std::clamp(std::floor((number - offset) / step + 0.5), 0.0, kMost));
}

TeHeightCode TeHeightCode::covering(double lowest, double highest, bool whole) {
  if (whole && lowest >= 0 && highest <= kMost)
    return {};
  if (whole && highest - lowest <= kMost)
    return {1, lowest};
  return {highest > lowest ? (highest - lowest) / kMost : 1, lowest};
}

TeResult<TeHeightCode> TeHeightCode::measured(const std::string& path, TeRows& rows,
                                              std::optional<double> also,
                                              const std::function<void(double)>& progress) {
  std::vector<double> numbers(std::size_t(rows.columns()));
  double lowest = also.value_or(std::numeric_limits<double>::infinity());
  double highest = also.value_or(-std::numeric_limits<double>::infinity());
  bool whole = !also || *also == std::floor(*also);
  long long missing = 0;
  std::string firstMissing;
  for (int row = 0; row < rows.rows(); ++row) {
    if (TeStatus ok = rows.read(row, numbers.data()); !ok)
      return ok.error();
    for (int column = 0; column < rows.columns(); ++column) {
      const double number = numbers[std::size_t(column)];
      if (std::isnan(number)) {
        if (++missing == 1)
          firstMissing = "column " + std::to_string(column) + ", row " + std::to_string(row);
        continue;
      }
      lowest = std::min(lowest, number);
      highest = std::max(highest, number);
      whole = whole && number == std::floor(number);
    }
    progress(double(row + 1) / rows.rows());
  }
  if (missing > 0)
    return TeError{path + ": " + std::to_string(missing) + " samples without data, the first in " +
                   firstMissing + "; --fill gives them a value"};
  return covering(lowest, highest, whole);
}
