#include "nodes/clipmap/TePyramidFiles.h"

#include <gtest/gtest.h>

namespace {

TEST(TePyramidFiles, ALevelIsNamedByItsNumber) {
  EXPECT_EQ(tePyramidLevelFile("/terrain/ps", 0), "/terrain/ps_0.raw");
  EXPECT_EQ(tePyramidLevelFile("ps_16k", 14), "ps_16k_14.raw");
}

TEST(TePyramidFiles, SidesAndLevelsBelongTogether) {
  for (int level = 1; level <= kTeHighestPyramidLevel; ++level)
    EXPECT_EQ(tePyramidLevelOfSide(tePyramidSide(level)), level);
  EXPECT_EQ(tePyramidSide(14), 16385);
  for (long long side : {-3LL, 0LL, 1LL, 2LL, 4LL, 16384LL, 16386LL, 131073LL, (1LL << 32) + 3})
    EXPECT_EQ(tePyramidLevelOfSide(side), -1) << side;
}

} // namespace
