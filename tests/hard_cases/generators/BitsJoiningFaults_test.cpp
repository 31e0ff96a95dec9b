#include "generators/base/TeHash.h"
#include "generators/joining/TeJoiningFaultBlock.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdio>

namespace {

/// A hash of the last map of a block, the same on machines of any byte order.
std::uint64_t hashOfBlock() {
  TeJoiningFaultParameters parameters;
  parameters.worldSeed = 2007;
  TeJoiningFaultBlock block = std::move(*TeJoiningFaultBlock::create(parameters));
  block.finish();
  const TeHeightMap& map = block.map(2, 2);
  std::uint64_t hash = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      hash = teHashDouble(hash, double(map.at(x, y)));
  return hash;
}

} // namespace

// Joining maps are no source of the registry, whose golden hashes are tested together; the same holds of
// them: the same bits from every compiler and whatever floating-point state a host program has left behind.
TEST(HardCase, BitsJoiningFaults) {
  const std::uint64_t golden = 9907005150812229485u;
  EXPECT_EQ(hashOfBlock(), golden);
  for (int rounding : {FE_UPWARD, FE_TOWARDZERO}) {
    std::fesetround(rounding);
    EXPECT_EQ(hashOfBlock(), golden) << rounding;
  }
  std::fesetround(FE_TONEAREST);
  std::printf("BitsJoiningFaults: 1 golden hash, 3 rounding modes\n");
}
