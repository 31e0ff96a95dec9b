#include "engine/camera/TeClipRange.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kSlopes = 1.5;    ///< of the reach: 45° up or down over all of it is 1.42
constexpr double kInside = 1e-3;   ///< metres to an object; closer is inside of it
constexpr double kFarthest = 1e30; ///< metres, so that floats stay finite
constexpr double kHeightPart = 10; ///< of the height: near cuts only slopes steeper than 84°

double powerOfTwoFrom(double value) { return std::exp2(std::ceil(std::log2(value))); }
double powerOfTwoTo(double value) { return std::exp2(std::floor(std::log2(value))); }

} // namespace

TeClipRange TeClipRange::of(double reach, double heightAboveGround, double objectDistance) {
  const double height =
      std::isfinite(heightAboveGround) ? std::clamp(heightAboveGround, 0.0, kFarthest) : 0.0;
  const double needed = std::min(kSlopes * std::max(reach, 1.0) + height + objectDistance, kFarthest);
  TeClipRange range;
  range.farDistance = powerOfTwoFrom(needed);
  range.nearDistance = std::max(range.farDistance / kFarPerNear, TeClipRange::kNearest);
  if (height / kHeightPart > range.nearDistance)
    range.nearDistance = powerOfTwoTo(height / kHeightPart);
  if (objectDistance > kInside && range.nearDistance > objectDistance / 2)
    range.nearDistance = std::max(powerOfTwoTo(objectDistance / 2), TeClipRange::kNearest);
  return range;
}
