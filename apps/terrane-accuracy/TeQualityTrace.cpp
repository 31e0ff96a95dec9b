#include "apps/terrane-accuracy/TeQualityTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr double kSettled = 1; ///< seconds

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

std::optional<double> TeQualityTrace::returned(const Step& step, double part) const {
  std::vector<double> last;
  for (const Frame& frame : frames) {
    if (frame.time <= step.begin || frame.time > step.end)
      continue;
    last.push_back(frame.seconds);
    if (last.size() > std::size_t(kMedian))
      last.erase(last.begin());
    if (last.size() == std::size_t(kMedian) && std::fabs(median(last) / goal - 1) <= part)
      return frame.time - step.begin;
  }
  return {};
}

double TeQualityTrace::settledCost(const Step& step) const {
  std::vector<double> costs;
  for (const Frame& frame : frames)
    if (frame.time > step.begin + kSettled && frame.time <= step.end)
      costs.push_back(frame.seconds / goal);
  return costs.empty() ? std::numeric_limits<double>::quiet_NaN() : median(std::move(costs));
}

int TeQualityTrace::turns(const Step& step) const {
  int turns = 0;
  double before = 0, last = 0;
  for (const Frame& frame : frames) {
    if (frame.time <= step.begin + kSettled || frame.time > step.end)
      continue;
    const double change = last > 0 ? frame.pixelError - last : 0;
    turns += change * before < 0;
    before = change != 0 ? change : before;
    last = frame.pixelError;
  }
  return turns;
}
