#include "patchdb/TeKeySet.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <set>
#include <utility>

TEST(TeKeySet, IsASet) {
  TeKeySet keys;
  EXPECT_FALSE(keys.contains(0, 0));
  EXPECT_TRUE(keys.empty());
  EXPECT_TRUE(keys.insert(3, -5));
  EXPECT_FALSE(keys.insert(3, -5));
  EXPECT_TRUE(keys.contains(3, -5));
  EXPECT_FALSE(keys.contains(-5, 3));
  EXPECT_EQ(keys.size(), 1u);
}

TEST(TeKeySet, AgreesWithAPlainSetNearAndFarAndAtTheRim) {
  TeRandom random(4, 5, {});
  constexpr std::int64_t kRim = std::numeric_limits<std::int64_t>::max();
  const std::int64_t centres[] = {0,         -1,        std::int64_t(1) << 47, -(std::int64_t(1) << 47),
                                  kRim - 40, -kRim + 40};
  TeKeySet keys;
  std::set<std::pair<std::int64_t, std::int64_t>> reference;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t x = centres[random.below(6)] + (std::int64_t(random.below(64)) - 32);
    const std::int64_t y = centres[random.below(6)] + (std::int64_t(random.below(64)) - 32);
    EXPECT_EQ(keys.contains(x, y), reference.count({x, y}) == 1);
    if (i % 2 == 0) {
      EXPECT_EQ(keys.insert(x, y), reference.insert({x, y}).second);
    }
  }
  EXPECT_EQ(keys.size(), reference.size());
}

TEST(TeKeySet, IsCompactWhereKeysLieTogether) {
  TeKeySet square, line, lonely;
  for (std::int64_t y = 0; y < 1000; ++y)
    for (std::int64_t x = 0; x < 1000; ++x)
      square.insert(x, y);
  for (std::int64_t x = 0; x < 100000; ++x) // a straight flight with a block of 3×3 patches
    for (std::int64_t y = -1; y <= 2; ++y)
      line.insert(x, y);
  for (std::int64_t i = 0; i < 10000; ++i)
    lonely.insert(1000 * i, -500 * i);
  const auto perKey = [](const TeKeySet& keys) { return double(keys.bytes()) / double(keys.size()); };
  std::printf("TeKeySet: %.2f bytes a key in a square, %.2f along a flight, %.0f where each is alone\n",
              perKey(square), perKey(line), perKey(lonely));
  EXPECT_LT(perKey(square), 1.0);
  EXPECT_LT(perKey(line), 5.0);
  EXPECT_LE(perKey(lonely), 64.0);
}
