#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

TEST(TeRandom, IsAPureFunctionOfSeedDomainKeyAndCounter) {
  TeRandom stream(7, 8, {9, -10});
  const TeRandom same(7, 8, {9, -10});
  for (std::uint64_t i = 0; i < 100; ++i)
    EXPECT_EQ(stream.next(), same.at(i));
  EXPECT_EQ(same.at(0), same.at(0));
}

// Should one of these change, every world made so far changes.
TEST(TeRandom, KeepsItsNumbersForEver) {
  const TeRandom random(1, 2, {3, 4});
  TeRandom uniform(1, 2, {3, 4});
  EXPECT_EQ(uniform.uniform(), double(random.at(0) >> 11) * 0x1p-53);
  EXPECT_EQ(random.at(0), 0xE9E4F560AB9CCE1Eull);
  EXPECT_EQ(random.at(1), 0xDF12FFF528F0FAC9ull);
  EXPECT_EQ(TeRandom(UINT64_MAX, 0, {-5, std::int64_t(1) << 40}).at(7), 0xFA1CC8A23CAC02F0ull);
}

TEST(TeRandom, NeighbouringStreamsHaveNothingInCommon) {
  std::set<std::uint64_t> seen;
  int numbers = 0;
  const auto take = [&](std::uint64_t seed, std::uint64_t domain, TeMapKey key) {
    const TeRandom random(seed, domain, key);
    for (std::uint64_t i = 0; i < 20; ++i, ++numbers)
      seen.insert(random.at(i));
  };
  for (int a = -8; a < 8; ++a)
    for (int b = -8; b < 8; ++b) {
      take(1, 2, {a, b});
      take(1, std::uint64_t(100 + a), {b, 1000});
      take(std::uint64_t(100 + a), 5, {2000, b});
    }
  EXPECT_EQ(int(seen.size()), numbers);
}

TEST(TeRandom, NumbersAreUniformAcrossCountersAndKeys) {
  constexpr int kBins = 100;
  constexpr int kDraws = 200000;
  for (bool acrossKeys : {false, true}) {
    std::vector<int> bins(kBins, 0);
    TeRandom stream(3, 4, {});
    double sum = 0;
    for (int i = 0; i < kDraws; ++i) {
      const double u = acrossKeys ? TeRandom(3, 4, {i % 500, i / 500}).uniform() : stream.uniform();
      ASSERT_GE(u, 0.0);
      ASSERT_LT(u, 1.0);
      ++bins[std::size_t(u * kBins)];
      sum += u;
    }
    double chiSquare = 0;
    for (int count : bins)
      chiSquare += std::pow(count - double(kDraws) / kBins, 2) / (double(kDraws) / kBins);
    EXPECT_LT(chiSquare, 160) << "99 degrees of freedom: 1 in 10,000 is above";
    EXPECT_GT(chiSquare, 50);
    EXPECT_NEAR(sum / kDraws, 0.5, 0.003);
  }
}

TEST(TeRandom, RangesAreKept) {
  TeRandom random(3, 4, {});
  std::vector<int> counts(6, 0);
  for (int i = 0; i < 60000; ++i) {
    const std::uint64_t n = random.below(6);
    ASSERT_LT(n, 6u);
    ++counts[n];
    const double u = random.uniform(-3.0, 5.0);
    ASSERT_GE(u, -3.0);
    ASSERT_LT(u, 5.0);
  }
  for (int count : counts)
    EXPECT_NEAR(count, 10000, 500);
  EXPECT_EQ(random.below(1), 0u);
}

TEST(TeRandom, ScaledBitsStayBelowTheirBound) {
  for (std::int64_t bound : {std::int64_t(1), std::int64_t(7), std::int64_t(1) << 40}) {
    EXPECT_EQ(TeRandom::scaled(0, bound), 0);
    EXPECT_LT(TeRandom::scaled(0xFFFFFFFFu, bound), bound);
    EXPECT_EQ(TeRandom::scaled(0x80000000u, bound), bound / 2);
  }
}
