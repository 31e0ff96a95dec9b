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

TeHeightMap blend(const TeHeightMap& southWest, const TeHeightMap& southEast, const TeHeightMap& northWest,
                  const TeHeightMap& northEast) {
  const int side = (southWest.width() + 1) / 2;
  TeHeightMap patch = *TeHeightMap::create(side, side);
  TeFourMapBlend(southWest, southEast, northWest, northEast, patch).finish();
  return patch;
}

} // namespace

// The upper half of the weight matrix of a 9×9 map, row by row from its rim: it is the southern part of the
// patches north of the map's centre, seen from their south-east and south-west maps.
TEST(TeFourMapBlend, WeightsAreThoseOfTheDocumentsExample) {
  const double expected[5][9] = {{0, 0, 0, 0, 0, 0, 0, 0, 0},
                                 {0, .0625, .125, .1875, .25, .1875, .125, .0625, 0},
                                 {0, .125, .25, .375, .5, .375, .25, .125, 0},
                                 {0, .1875, .375, .5625, .75, .5625, .375, .1875, 0},
                                 {0, .25, .5, .75, 1, .75, .5, .25, 0}};
  for (int row = 0; row <= 4; ++row)
    for (int column = 0; column < 9; ++column) {
      const int y = 4 - row; // rows of the patch rise northward, the matrix is printed from the rim
      const double weight = column <= 4 ? double(TeFourMapBlend::weight(4, 1, column, y)) / 16
                                        : double(TeFourMapBlend::weight(4, 0, column - 4, y)) / 16;
      EXPECT_EQ(weight, expected[row][column]) << row << ", " << column;
    }
}

TEST(TeFourMapBlend, FourWeightsSumToExactlyOneAndAgreeOnBorders) {
  for (int n : {1, 2, 3, 4, 7, 32, 100})
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        std::int64_t sum = 0;
        for (int map = 0; map < 4; ++map)
          sum += TeFourMapBlend::weight(n, map, x, y);
        ASSERT_EQ(sum, std::int64_t(n) * n);
        // On the east border the eastern maps weigh what they weigh in the neighbour as western maps.
        ASSERT_EQ(TeFourMapBlend::weight(n, 1, n, y), TeFourMapBlend::weight(n, 0, 0, y));
        ASSERT_EQ(TeFourMapBlend::weight(n, 3, n, y), TeFourMapBlend::weight(n, 2, 0, y));
        ASSERT_EQ(TeFourMapBlend::weight(n, 2, x, n), TeFourMapBlend::weight(n, 0, x, 0));
      }
}

TEST(TeFourMapBlend, BlendsAsTheWeightsSay) {
  for (int side : {3, 5, 7, 9, 17, 65, 67}) {
    const int n = (side - 1) / 2;
    TeHeightMap maps[4];
    TeRandom random(1, std::uint64_t(side), {});
    for (TeHeightMap& map : maps) {
      map = filled(side, 0);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          map.at(x, y) = float(random.uniform(-4000, 4000));
    }
    const TeHeightMap patch = blend(maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        double sum = 0;
        for (int map = 0; map < 4; ++map)
          sum += double(TeFourMapBlend::weight(n, map, x, y)) *
                 maps[map].at(map % 2 == 0 ? n + x : x, map / 2 == 0 ? n + y : y);
        ASSERT_EQ(patch.at(x, y), float(sum / (double(n) * n))) << side << ": " << x << ", " << y;
      }
  }
}

TEST(TeFourMapBlend, FourEqualHeightsComeBackBitForBit) {
  for (int n : {1, 2, 3, 4, 5, 7, 16, 31, 32, 33, 50, 127}) {
    const TeHeightMap all =
        randomMap(4 * n + 1, std::uint64_t(n)); // a global map of which each takes its part
    TeHeightMap maps[4];
    for (int m = 0; m < 4; ++m) {
      maps[m] = filled(2 * n + 1, 0);
      ASSERT_TRUE(maps[m].copy(all, {m % 2 * n, m / 2 * n, 2 * n + 1, 2 * n + 1}, maps[m].bounds()));
    }
    const TeHeightMap patch = blend(maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        const float expected = all.at(n + x, n + y);
        const float actual = patch.at(x, y);
        ASSERT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0) << n << ": " << x << ", " << y;
      }
  }
  for (float height : {0.0f, -0.0f, kLargest, -kLargest, 1e-45f, -1e-45f, 8848.86f}) {
    const TeHeightMap map = filled(13, height);
    const TeHeightMap patch = blend(map, map, map, map);
    for (int i = 0; i < 49; ++i)
      ASSERT_EQ(std::memcmp(patch.data() + i, &height, sizeof height), 0) << height;
  }
}

TEST(TeFourMapBlend, ASampleIsMissingIfAnInputOfPositiveWeightIs) {
  const int n = 6;
  for (int hole = 0; hole < 4; ++hole) {
    TeHeightMap maps[4];
    for (int m = 0; m < 4; ++m)
      maps[m] = filled(2 * n + 1, m == hole ? TeHeightMap::missing() : float(m + 1));
    const TeHeightMap patch = blend(maps[0], maps[1], maps[2], maps[3]);
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        ASSERT_EQ(TeHeightMap::isMissing(patch.at(x, y)), TeFourMapBlend::weight(n, hole, x, y) > 0)
            << hole << ": " << x << ", " << y;
  }
}

TEST(TeFourMapBlend, SlicesOfAnyLengthGiveTheSameBits) {
  for (int side : {5, 33, 301, 1025}) {
    const int rows = (side + 1) / 2;
    const TeHeightMap a = randomMap(side, 1), b = randomMap(side, 2), c = randomMap(side, 3),
                      d = randomMap(side, 4);
    const TeHeightMap whole = blend(a, b, c, d);
    for (int units : {1, 2, 5, 100}) {
      TeHeightMap patch = filled(rows, -1);
      TeFourMapBlend sliced(a, b, c, d, patch);
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

TEST(TeFourMapBlend, StaysWithinItsInputs) {
  const TeHeightMap a = filled(33, kLargest), b = filled(33, -kLargest);
  const TeHeightMap patch = blend(a, b, b, a);
  for (int i = 0; i < 17 * 17; ++i)
    ASSERT_TRUE(std::isfinite(patch.data()[i]));
  EXPECT_EQ(patch.at(0, 0), kLargest);
  EXPECT_EQ(patch.at(16, 0), -kLargest);
  EXPECT_EQ(patch.at(8, 8), 0.0f);
}
