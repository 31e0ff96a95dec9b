#include "nodes/lod/TeMeshBudget.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kCoarsest = 1e12;
constexpr double kStep = 64;   ///< from one try to the next
constexpr double kAim = 0.975; ///< of the budget: the middle of what is accepted

} // namespace

double TeMeshBudget::search(std::int64_t budget, double start,
                            const std::function<std::int64_t(double)>& triangles) {
  double tooFine = 0, keeps = 0; // tried ones; 0: none
  double tried = start, before = 0, countBefore = 0;
  double power = 1; // triangles ~ coarsening ^ -power, by the last two tries
  for (int i = 0;; i++) {
    const double count = double(std::max<std::int64_t>(1, triangles(tried)));
    const bool fits = count <= double(budget);
    if ((fits && (tried <= 1 || count >= kUsed * double(budget))) || (!fits && tried >= kCoarsest))
      return tried;
    (fits ? keeps : tooFine) = tried;
    const double width = tooFine > 0 && keeps > 0 ? keeps / tooFine : 0; // 0: nothing is enclosed
    if (keeps > 0 && (i >= kTries || (width > 0 && width < 1 + 1e-6))) {
      if (!fits)
        triangles(keeps);
      return keeps;
    }
    if (before > 0 && count != countBefore)
      power = std::clamp(std::log(countBefore / count) / std::log(tried / before), 0.25, 4.0);
    before = tried;
    countBefore = count;
    const double times = std::pow(count / (kAim * double(budget)), 1 / power);
    tried = std::clamp(tried * std::clamp(times, 1.0 / kStep, kStep), 1.0, kCoarsest);
    if (width > 0) // away from both, so that each try tells something
      tried = std::clamp(tried, tooFine * std::pow(width, 0.05), tooFine * std::pow(width, 0.95));
  }
}
