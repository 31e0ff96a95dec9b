#include "patchdb/TeCoarseHeights.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

std::unique_ptr<TePatchDatabase> roughBlock(int samples, int patches) {
  auto database = teSampleWorld(
      [](std::int64_t x, std::int64_t y) {
        return float(std::sin(double(x) * 12.9898 + double(y) * 78.233) * 50 + double(x - y));
      },
      samples, 0.5);
  for (int y = -patches; y < patches; ++y)
    for (int x = -patches; x < patches; ++x)
      EXPECT_TRUE(database->build({x, y, 0}));
  return database;
}

} // namespace

TEST(TeCoarseHeights, SamplesAreThoseOfTheBaseLevel) {
  for (int samples : {9, 15, 17}) // 4, 7 and 8 cells a patch
    for (int level : {1, 2}) {
      auto database = roughBlock(samples, 4);
      const int n = database->lattice().cells();
      for (const TePatchKey key : {TePatchKey{0, 0, level}, {-1, -1, level}, {0, -1, level}}) {
        const auto patch = database->buildCoarse(key);
        ASSERT_TRUE(patch) << patch.error().message;
        for (int y = 0; y <= n; ++y)
          for (int x = 0; x <= n; ++x) {
            const auto at = tePatchFirstSample(database->lattice(), key) +
                            glm::vec<2, std::int64_t>(std::int64_t(x) << level, std::int64_t(y) << level);
            const glm::dvec2 point(database->lattice().position(at.x), database->lattice().position(at.y));
            const auto base = database->surfaceAt(point, 0);
            ASSERT_TRUE(base);
            ASSERT_EQ(double((*patch)->heights().at(x, y)), base->height);
          }
      }
    }
}

TEST(TeCoarseHeights, TheBaseSurfaceIsNowhereFartherThanTheDeviationAndSomewhereAsFar) {
  auto database = roughBlock(17, 4);
  TeRandom random(2, 2, {});
  for (int level : {1, 2}) {
    const float deviation = (*database->buildCoarse({0, 0, level}))->deviation();
    const double side = database->lattice().patchSide() * (1 << level);
    const glm::dvec2 corner = tePatchOrigin(database->lattice(), {0, 0, level});
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      glm::dvec2 point = corner + glm::dvec2(random.uniform(0, side), random.uniform(0, side));
      if (i % 2 == 0) // a sample
        point = {database->lattice().position(std::int64_t(random.below(std::uint64_t(8 << level)))),
                 database->lattice().position(std::int64_t(random.below(std::uint64_t(8 << level))))};
      const auto coarse = database->surfaceAt(point, level);
      ASSERT_TRUE(coarse);
      EXPECT_EQ(coarse->deviation, double(deviation));
      worst = std::max(worst, std::fabs(coarse->height - database->surfaceAt(point, 0)->height));
    }
    EXPECT_LE(worst, double(deviation));
    EXPECT_NEAR(worst, double(deviation), 1e-4 * deviation);
  }
}

TEST(TeCoarseHeights, APlaneHasNoDeviation) {
  auto database = teSampleWorld([](std::int64_t x, std::int64_t y) { return float(3 * x - 2 * y); }, 17);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  EXPECT_EQ((*database->buildCoarse({0, 0, 1}))->deviation(), 0.0f);
}

TEST(TeCoarseHeights, SaysWhichPatchIsMissing) {
  auto database = roughBlock(17, 1);
  EXPECT_FALSE(database->buildCoarse({0, 0, 0}));
  EXPECT_FALSE(database->buildCoarse({0, 0, 13}));
  EXPECT_FALSE(database->buildCoarse({std::int64_t(1) << 60, 0, 1}));
  const auto patch = database->buildCoarse({0, 0, 1});
  ASSERT_FALSE(patch);
  EXPECT_EQ(patch.error().message, "patch (0, 0) level 1: the base patch (1, 0) level 0 has no heights");
  EXPECT_EQ(database->find({0, 0, 1}), nullptr);
}
