#include "patchdb/TeFourMapBlend.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

constexpr float kLargest = 3.4028234e38f;

TeHeightMap filled(int side, float height) {
  TeHeightMap map = *TeHeightMap::create(side, side);
  map.fillMissing(0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map.at(x, y) = height;
  return map;
}

/// Floats of every magnitude and sign, by their bits.
TeHeightMap randomMap(int side, std::uint64_t seed) {
  TeHeightMap map = *TeHeightMap::create(side, side);
  TeRandom random(seed, 11, {});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::uint32_t bits = std::uint32_t(random.next());
      float height;
      std::memcpy(&height, &bits, sizeof height);
      map.at(x, y) = std::isfinite(height) ? height : 0.25f;
    }
  return map;
}

TeHeightMap blend(TeBlendProfile profile, const TeHeightMap& southWest, const TeHeightMap& southEast,
                  const TeHeightMap& northWest, const TeHeightMap& northEast) {
  const int side = (southWest.width() + 1) / 2;
  TeHeightMap patch = *TeHeightMap::create(side, side);
  const TeBlendWeights weights(side - 1, profile);
  TeFourMapBlend(weights, southWest, southEast, northWest, northEast, patch).finish();
  return patch;
}

} // namespace

class TeFourMapBlendOfProfile : public testing::TestWithParam<TeBlendProfile> {};
INSTANTIATE_TEST_SUITE_P(Profiles, TeFourMapBlendOfProfile,
                         testing::Values(TeBlendProfile::Linear, TeBlendProfile::Smooth),
                         [](const auto& info) {
                           return info.param == TeBlendProfile::Linear ? "Linear" : "Smooth";
                         });

TEST_P(TeFourMapBlendOfProfile, BlendsAsTheWeightsSay) {
  for (int side : {3, 5, 7, 9, 17, 65, 67}) {
    const int n = (side - 1) / 2;
    const TeBlendWeights weights(n, GetParam());
    const double whole = double(weights.whole()) * weights.whole();
    TeHeightMap maps[4];
    TeRandom random(1, std::uint64_t(side), {});
    for (TeHeightMap& map : maps) {
      map = filled(side, 0);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          map.at(x, y) = float(random.uniform(-4000, 4000));
    }
    const TeHeightMap patch = blend(GetParam(), maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        double sum = 0;
        for (int map = 0; map < 4; ++map)
          sum += double(weights.weight(map, x, y)) *
                 maps[map].at(map % 2 == 0 ? n + x : x, map / 2 == 0 ? n + y : y);
        ASSERT_EQ(patch.at(x, y), float(sum / whole)) << side << ": " << x << ", " << y;
      }
  }
}

TEST_P(TeFourMapBlendOfProfile, FourEqualHeightsComeBackBitForBit) {
  for (int n : {1, 2, 3, 4, 5, 7, 16, 31, 32, 33, 50, 127}) {
    const TeHeightMap all =
        randomMap(4 * n + 1, std::uint64_t(n)); // a global map of which each takes its part
    TeHeightMap maps[4];
    for (int m = 0; m < 4; ++m) {
      maps[m] = filled(2 * n + 1, 0);
      ASSERT_TRUE(maps[m].copy(all, {m % 2 * n, m / 2 * n, 2 * n + 1, 2 * n + 1}, maps[m].bounds()));
    }
    const TeHeightMap patch = blend(GetParam(), maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        const float expected = all.at(n + x, n + y);
        const float actual = patch.at(x, y);
        ASSERT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0) << n << ": " << x << ", " << y;
      }
  }
  for (float height : {0.0f, -0.0f, kLargest, -kLargest, 1e-45f, -1e-45f, 8848.86f}) {
    const TeHeightMap map = filled(13, height);
    const TeHeightMap patch = blend(GetParam(), map, map, map, map);
    for (int i = 0; i < 49; ++i)
      ASSERT_EQ(std::memcmp(patch.data() + i, &height, sizeof height), 0) << height;
  }
}

TEST_P(TeFourMapBlendOfProfile, ASampleIsMissingIfAnInputOfPositiveWeightIs) {
  const int n = 200; // so large that the outermost smooth weights would round to 0
  const TeBlendWeights weights(n, GetParam());
  for (int hole = 0; hole < 4; ++hole) {
    TeHeightMap maps[4];
    for (int m = 0; m < 4; ++m)
      maps[m] = filled(2 * n + 1, m == hole ? TeHeightMap::missing() : float(m + 1));
    const TeHeightMap patch = blend(GetParam(), maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        ASSERT_EQ(TeHeightMap::isMissing(patch.at(x, y)), weights.weight(hole, x, y) > 0)
            << hole << ": " << x << ", " << y;
  }
}

TEST_P(TeFourMapBlendOfProfile, SlicesOfAnyLengthGiveTheSameBits) {
  for (int side : {5, 33, 301, 1025}) {
    const int rows = (side + 1) / 2;
    const TeBlendWeights weights(rows - 1, GetParam());
    const TeHeightMap a = randomMap(side, 1), b = randomMap(side, 2), c = randomMap(side, 3),
                      d = randomMap(side, 4);
    const TeHeightMap whole = blend(GetParam(), a, b, c, d);
    for (int units : {1, 2, 5, 100}) {
      TeHeightMap patch = filled(rows, -1);
      TeFourMapBlend sliced(weights, a, b, c, d, patch);
      int slices = 0;
      bool done = false;
      while (!done) {
        TeAllowance allowance = TeAllowance::units(units);
        done = sliced.step(allowance);
        ++slices;
      }
      EXPECT_TRUE(patch == whole) << side << " " << units;
      EXPECT_EQ(slices > 1, std::int64_t(rows) * rows > 4096 * std::int64_t(units)) << side << " " << units;
    }
  }
}

TEST_P(TeFourMapBlendOfProfile, StaysWithinItsInputs) {
  const TeHeightMap a = filled(33, kLargest), b = filled(33, -kLargest);
  const TeHeightMap patch = blend(GetParam(), a, b, b, a);
  for (int i = 0; i < 17 * 17; ++i)
    ASSERT_TRUE(std::isfinite(patch.data()[i]));
  EXPECT_EQ(patch.at(0, 0), kLargest);
  EXPECT_EQ(patch.at(16, 0), -kLargest);
  EXPECT_EQ(patch.at(8, 8), 0.0f);
}
