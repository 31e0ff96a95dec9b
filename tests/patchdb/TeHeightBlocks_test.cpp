#include "patchdb/TeHeightBlocks.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

TeHeightMap noisyMap(int width, int height, std::uint64_t seed) {
  TeHeightMap map = *TeHeightMap::create(width, height);
  TeRandom random(seed, 1, {});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.at(x, y) = float(random.uniform(-500, 500));
  return map;
}

} // namespace

TEST(TeHeightBlocks, RangesAreThoseOfTheirSamples) {
  for (const auto& [width, height] :
       {std::pair(2, 2), {5, 9}, {9, 9}, {10, 17}, {33, 33}, {66, 130}, {600, 35}})
    for (const bool missing : {false, true}) {
      TeHeightMap map = noisyMap(width, height, 3);
      if (missing)
        map.at(width / 2, height / 3) = TeHeightMap::missing();
      const TeHeightBlocks blocks(map, missing);
      ASSERT_GT(blocks.levels(), 0);
      for (int level = 1; level <= blocks.levels(); ++level) {
        const int side = 1 << (TeHeightBlocks::kShift * level);
        for (int y = 0; y * side < height - 1; ++y)
          for (int x = 0; x * side < width - 1; ++x) {
            float low = INFINITY, high = -INFINITY;
            for (int j = y * side; j <= std::min((y + 1) * side, height - 1); ++j)
              for (int i = x * side; i <= std::min((x + 1) * side, width - 1); ++i) {
                const bool hole = TeHeightMap::isMissing(map.at(i, j));
                low = std::min(low, hole ? -INFINITY : map.at(i, j));
                high = std::max(high, hole ? INFINITY : map.at(i, j));
              }
            ASSERT_EQ(blocks.range(level, x, y).low, low) << width << " " << level << " " << x << " " << y;
            ASSERT_EQ(blocks.range(level, x, y).high, high);
          }
      }
      const int whole = 1 << (TeHeightBlocks::kShift * blocks.levels());
      EXPECT_GE(whole, std::max(width, height) - 1);
    }
}

TEST(TeHeightBlocks, TakeLittleMemory) {
  for (int side : {33, 65, 257, 1025}) {
    const TeHeightBlocks blocks(noisyMap(side, side, 1), false);
    EXPECT_LT(double(blocks.bytes()) / (side * side), 0.2) << side;
  }
  EXPECT_EQ(TeHeightBlocks(TeHeightMap(), false).levels(), 0);
}
