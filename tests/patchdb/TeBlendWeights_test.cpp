#include "patchdb/TeBlendWeights.h"

#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TePatchDatabase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace {

/// Root mean square of the second difference of heights along x, in the column `column` of patches.
double bendOfColumn(TeBlendProfile profile, int column) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    TeWorld world{*TeLattice::create(65, 1.0), seed, nullptr, profile};
    world.sources = std::make_shared<TeSingleSource>(
        *TeGeneratorRegistry::instance().source(TeGeneratorRegistry::kDefaultGenerator));
    const auto database = std::move(*TePatchDatabase::create(world));
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t x = -1; x <= 1; ++x)
        EXPECT_TRUE(database->build({x, y, 0}));
    for (int border : {-16, 16})
      for (int y = -48; y <= 48; ++y) {
        const double x = border + column;
        const double bend = *database->heightAt({x - 1, y}) - 2 * *database->heightAt({x, y}) +
                            *database->heightAt({x + 1, y});
        sum += bend * bend;
        ++count;
      }
  }
  return std::sqrt(sum / count);
}

} // namespace

// The upper half of the weight matrix of a 9×9 map, row by row from its rim: it is the southern part of the
// patches north of the map's centre, seen from their south-east and south-west maps.
TEST(TeBlendWeights, LinearOnesAreThoseOfTheDocumentsExample) {
  const double expected[5][9] = {{0, 0, 0, 0, 0, 0, 0, 0, 0},
                                 {0, .0625, .125, .1875, .25, .1875, .125, .0625, 0},
                                 {0, .125, .25, .375, .5, .375, .25, .125, 0},
                                 {0, .1875, .375, .5625, .75, .5625, .375, .1875, 0},
                                 {0, .25, .5, .75, 1, .75, .5, .25, 0}};
  const TeBlendWeights weights(4, TeBlendProfile::Linear);
  for (int row = 0; row <= 4; ++row)
    for (int column = 0; column < 9; ++column) {
      const int y = 4 - row; // rows of the patch rise northward, the matrix is printed from the rim
      const std::int64_t weight =
          column <= 4 ? weights.weight(1, column, y) : weights.weight(0, column - 4, y);
      EXPECT_EQ(double(weight) / 16, expected[row][column]) << row << ", " << column;
    }
}

TEST(TeBlendWeights, SumToExactlyOneAndAgreeOnBorders) {
  for (TeBlendProfile profile : {TeBlendProfile::Linear, TeBlendProfile::Smooth})
    for (int n : {1, 2, 3, 4, 7, 32, 100, 511}) {
      const TeBlendWeights weights(n, profile);
      const std::int64_t whole = std::int64_t(weights.whole()) * weights.whole();
      for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
          std::int64_t sum = 0;
          for (int map = 0; map < 4; ++map)
            sum += weights.weight(map, x, y);
          ASSERT_EQ(sum, whole);
          // On the east border the eastern maps weigh what they weigh in the neighbour as western maps.
          ASSERT_EQ(weights.weight(1, n, y), weights.weight(0, 0, y));
          ASSERT_EQ(weights.weight(3, n, y), weights.weight(2, 0, y));
          ASSERT_EQ(weights.weight(2, x, n), weights.weight(0, x, 0));
        }
    }
}

TEST(TeBlendWeights, RiseFromZeroToTheWholeAndAreSymmetric) {
  for (TeBlendProfile profile : {TeBlendProfile::Linear, TeBlendProfile::Smooth})
    for (int n : {1, 2, 5, 32, 333, 8192}) {
      const TeBlendWeights weights(n, profile);
      EXPECT_EQ(weights.rising()[0], 0);
      EXPECT_EQ(weights.rising()[n], weights.whole());
      for (int x = 1; x <= n; ++x) {
        ASSERT_GE(weights.rising()[x], weights.rising()[x - 1]) << n << ": " << x;
        ASSERT_GT(weights.rising()[x], 0) << n << ": " << x;
        ASSERT_EQ(weights.rising()[x] + weights.rising()[n - x], weights.whole()) << n << ": " << x;
      }
    }
}

// What makes no crease: near the border a smooth weight is smaller than any slope of the linear one.
TEST(TeBlendWeights, SmoothOnesLeaveTheBorderWithoutSlopeOrCurvature) {
  for (int n : {16, 32, 128, 1024}) {
    const TeBlendWeights weights(n, TeBlendProfile::Smooth);
    for (int x = 0; x <= n; ++x) {
      const double t = double(x) / n;
      // 10t³ bounds the quintic; half a unit of rounding, and weights are at least one unit.
      ASSERT_LE(weights.rising()[x] / weights.whole(), 10 * t * t * t + 1.0 / weights.whole());
      const double exact = t * t * t * (10 - t * (15 - 6 * t));
      ASSERT_NEAR(weights.rising()[x] / weights.whole(), exact, 1.0 / weights.whole());
    }
  }
}

// The land of the default world bends across borders as it does beside them; linear weights crease it.
TEST(TeBlendWeights, SmoothOnesMakeNoCreaseInTheDefaultWorld) {
  double excess[2];
  for (TeBlendProfile profile : {TeBlendProfile::Linear, TeBlendProfile::Smooth}) {
    const double beside = 0.5 * (bendOfColumn(profile, -1) + bendOfColumn(profile, 1));
    excess[int(profile)] = bendOfColumn(profile, 0) / beside;
  }
  std::printf("bend across borders to bend beside them: linear %.2f, smooth %.2f\n", excess[0], excess[1]);
  EXPECT_LT(excess[int(TeBlendProfile::Smooth)], 1.1);
  EXPECT_GT(excess[int(TeBlendProfile::Linear)], 1.4);
}
