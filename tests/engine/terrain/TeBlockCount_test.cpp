#include "engine/terrain/TeBlockCount.h"

#include <gtest/gtest.h>

#include <set>

namespace {

TEST(TeBlockCount, PatchesThatWereCompleteAreNotLookedAtAgain) {
  TeBlockCount count;
  count.begin({{5, 5, 0}, 1});
  std::set<TePatchKey> complete;
  int looks = 0;
  const auto update = [&] {
    looks = 0;
    count.update(
        [&](const TePatchKey& key) {
          ++looks;
          return complete.count(key) > 0;
        },
        [](const TePatchKey& key) { return key.y >= 5; });
  };
  update();
  EXPECT_EQ(count.counts().block, 9);
  EXPECT_EQ(count.counts().missing, 9);
  EXPECT_EQ(count.counts().missingInView, 6);
  EXPECT_EQ(looks, 9);

  complete = {{4, 4, 0}, {5, 5, 0}};
  update();
  EXPECT_EQ(count.counts().drawn, 2);
  EXPECT_EQ(count.counts().missingInView, 5);
  update();
  EXPECT_EQ(looks, 7);

  for (std::int64_t y = 4; y <= 6; ++y)
    for (std::int64_t x = 4; x <= 6; ++x)
      complete.insert({x, y, 0});
  update();
  EXPECT_EQ(count.counts().missing, 0);
  update();
  EXPECT_EQ(looks, 0);
}

} // namespace
