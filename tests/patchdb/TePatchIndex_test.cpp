#include "patchdb/TePatchIndex.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TePatchData.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>

TEST(TePatchIndex, FindsWhatAMapFindsThroughAdditionsAndRemovals) {
  TeRandom random(5, 3, {});
  TePatchIndex index;
  std::map<std::pair<std::int64_t, std::int64_t>, std::unique_ptr<TePatchData>> expected;
  EXPECT_EQ(index.find(0, 0), nullptr);
  for (int i = 0; i < 30000; ++i) {
    // A block, a strip far away, and the rim of the world.
    const int kind = int(random.below(3));
    const std::int64_t limit = std::int64_t(1) << 47;
    const std::int64_t x = kind == 0   ? std::int64_t(random.below(30)) - 15
                           : kind == 1 ? 1000000 + std::int64_t(random.below(500))
                                       : limit - 1 - std::int64_t(random.below(9));
    const std::int64_t y = kind == 0   ? std::int64_t(random.below(30)) - 15
                           : kind == 1 ? std::int64_t(random.below(2))
                                       : -limit + std::int64_t(random.below(9));
    const auto known = expected.find({x, y});
    ASSERT_EQ(index.find(x, y), known == expected.end() ? nullptr : known->second.get());
    if (known == expected.end()) {
      index.reserve(index.size() + 1);
      auto& patch = expected[{x, y}];
      patch = std::make_unique<TePatchData>(TePatchKey{x, y, 0});
      index.add(*patch);
    } else if (random.below(2) == 0) {
      index.remove(*known->second);
      expected.erase(known);
    }
    ASSERT_EQ(index.size(), expected.size());
  }
  for (const auto& [key, patch] : expected)
    ASSERT_EQ(index.find(key.first, key.second), patch.get());
}

TEST(TePatchIndex, TakesAtMost64BytesAPatch) {
  TePatchIndex index;
  std::vector<std::unique_ptr<TePatchData>> patches;
  for (std::int64_t x = 0; x < 5000; ++x) {
    patches.push_back(std::make_unique<TePatchData>(TePatchKey{x, -x, 0}));
    index.reserve(index.size() + 1);
    index.add(*patches.back());
    ASSERT_LE(index.bytes(), 64 * std::max<std::size_t>(1, index.size()));
  }
}
