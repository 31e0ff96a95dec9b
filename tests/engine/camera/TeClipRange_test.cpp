#include "engine/camera/TeClipRange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace {

// The rules hold for every reach, height and distance that terrain and cameras can have.
TEST(TeClipRange, KeepsItsRules) {
  for (double reach = 1; reach < 1e6; reach *= 1.7)
    for (double height = 0; height < 1e5; height = height * 1.9 + 0.3)
      for (double distance = 0; distance < 1000; distance = distance * 1.6 + 0.2) {
        const TeClipRange range = TeClipRange::of(reach, height, distance);
        ASSERT_GE(range.nearDistance, TeClipRange::kNearest);
        ASSERT_LT(range.nearDistance, range.farDistance);
        // Level terrain below at the reach, and slopes of 45° up or down to there.
        ASSERT_GE(range.farDistance, std::hypot(reach, height));
        ASSERT_GE(range.farDistance, reach * std::sqrt(2.0) + height);
        ASSERT_LE(range.farDistance, 2 * (1.5 * reach + height + distance));
        if (distance > 2 * TeClipRange::kNearest) {
          ASSERT_LE(range.nearDistance, distance / 2) << reach << " " << height;
        }
        if (distance == 0) {
          ASSERT_GE(range.nearDistance * TeClipRange::kFarPerNear, range.farDistance);
          ASSERT_LE(range.nearDistance, std::max({height / 10, range.farDistance / TeClipRange::kFarPerNear,
                                                  TeClipRange::kNearest}));
        }
      }
}

TEST(TeClipRange, StaysWhileTheEyeMovesALittle) {
  std::set<std::pair<double, double>> ranges;
  for (double height = 5; height < 105; height += 0.1) {
    const TeClipRange range = TeClipRange::of(750, height, 18);
    ranges.insert({range.nearDistance, range.farDistance});
  }
  EXPECT_LE(ranges.size(), 5u) << "of 1000 frames";
}

TEST(TeClipRange, UnknownGroundIsThatBelowTheEye) {
  const TeClipRange level = TeClipRange::of(100, 0, 0);
  EXPECT_EQ(TeClipRange::of(100, std::numeric_limits<double>::quiet_NaN(), 0), level);
  EXPECT_EQ(TeClipRange::of(100, -50, 0), level);
}

} // namespace
