#include "engine/camera/TeViewFrustum.h"

#include "generators/base/TeRandom.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

const double kQuarter = std::acos(0.0);

/// Inventor's camera frame turned so that it looks north, level, z up.
const glm::dquat kNorth = glm::angleAxis(kQuarter, glm::dvec3(1, 0, 0));

TEST(TeViewFrustum, ByDefaultEverythingIsSeen) {
  EXPECT_TRUE(TeViewFrustum().meets({1e9, 1e9, 1e9}, {2e9, 2e9, 2e9}));
}

TEST(TeViewFrustum, WhatIsAheadIsSeenAndWhatIsBehindIsNot) {
  const TeViewFrustum frustum({1e6, 0, 10}, kNorth, kQuarter / 2, 1.5);
  EXPECT_NEAR(frustum.direction().y, 1, 1e-12);
  EXPECT_TRUE(frustum.meets({1e6 - 1, 10, 9}, {1e6 + 1, 12, 11}));
  EXPECT_FALSE(frustum.meets({1e6 - 1, -12, 9}, {1e6 + 1, -10, 11}));
  EXPECT_FALSE(frustum.meets({1e6 + 100, 10, 9}, {1e6 + 110, 12, 11})) << "far to the right";
  EXPECT_FALSE(frustum.meets({1e6 - 1, 10, 100}, {1e6 + 1, 12, 110})) << "far above";
  EXPECT_TRUE(frustum.meets({1e6 - 1000, -1000, -1000}, {1e6 + 1000, 1000, 1000})) << "the eye is inside";
}

TEST(TeViewFrustum, NoBoxWithAPointInViewIsLeftOut) {
  TeRandom random(7, 1, {0, 0});
  const auto number = [&random] { return 200 * random.uniform() - 100; };
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 eye{number(), number(), number()};
    const glm::dquat turn = glm::normalize(glm::dquat(number(), number(), number(), number()));
    const double angle = 0.2 + random.uniform();
    const double aspect = 0.5 + random.uniform();
    const TeViewFrustum frustum(eye, turn, angle, aspect);
    const glm::dvec3 point{number(), number(), number()};
    const glm::dvec3 local = glm::conjugate(turn) * (point - eye);
    const double up = std::tan(angle / 2) * -local.z;
    if (local.z < 0 && std::abs(local.y) < up && std::abs(local.x) < up * aspect) {
      ++seen;
      const glm::dvec3 size{random.uniform() * 10, random.uniform() * 10, random.uniform() * 10};
      EXPECT_TRUE(frustum.meets(point - size, point + size));
      EXPECT_TRUE(frustum.meets(point, point));
    } else {
      EXPECT_FALSE(frustum.meets(point, point)) << "a point is outside or inside";
    }
  }
  EXPECT_GT(seen, 100);
}

} // namespace
