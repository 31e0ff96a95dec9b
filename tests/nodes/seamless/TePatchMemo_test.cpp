#include "nodes/seamless/TePatchMemo.h"

#include <gtest/gtest.h>

TEST(TePatchMemo, makesEachNumberOnce) {
  TePatchMemo memo;
  int made = 0;
  for (int round = 0; round < 3; round++)
    for (std::int32_t y = 0; y < 60; y++)
      for (std::int32_t x = 0; x < 60; x++)
        for (const int level : {0, 7, 31})
          EXPECT_EQ(memo.get(level, x, y,
                             [&] {
                               made++;
                               return level * 1e4 + y * 100 + x;
                             }),
                    level * 1e4 + y * 100 + x);
  EXPECT_EQ(made, 60 * 60 * 3);
}

TEST(TePatchMemo, forgets) {
  TePatchMemo memo;
  const auto number = [&](double value) { return memo.get(3, 1, 2, [value] { return value; }); };
  EXPECT_EQ(number(1), 1);
  EXPECT_EQ(number(2), 1);
  memo.clear();
  EXPECT_EQ(number(2), 2);
}

TEST(TePatchMemo, tellsTheLargestPatchesApart) {
  TePatchMemo memo;
  const std::int32_t most = (1 << 29) - 1;
  EXPECT_EQ(memo.get(31, most, most, [] { return 1.0; }), 1);
  EXPECT_EQ(memo.get(31, most, most - 1, [] { return 2.0; }), 2);
  EXPECT_EQ(memo.get(30, most, most, [] { return 3.0; }), 3);
  EXPECT_EQ(memo.get(31, most, most, [] { return 4.0; }), 1);
}
