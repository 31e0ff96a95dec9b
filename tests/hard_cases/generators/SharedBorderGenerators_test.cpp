#include "generators/base/TeRandom.h"
#include "tests/generators/TeEveryGenerator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace {

constexpr int kSide = 17;
constexpr int kBlock = 4;

TeMapRequest request(int number) {
  static const TeLattice lattice = TeLattice::create(kSide, 10).value();
  const std::int64_t far = std::int64_t(1) << 40;
  return TeMapRequest::sourceMap(lattice, 4, {far + number % kBlock, -far + number / kBlock});
}

} // namespace

// The source maps behind a border, made in every order that a shuffle finds and in slices of every length:
// the row that two patches share rests on the same bits whoever asked first.
TEST(HardCase, SharedBorderGenerators) {
  long rows = 0;
  for (const TeChainUnderTest& chain : teEveryGenerator()) {
    const auto source = TeGeneratorRegistry::instance().source(chain.generator, chain.filters).value();
    std::vector<TeHeightMap> first(kBlock * kBlock);
    TeRandom random(5, 5, {});
    for (int round = 0; round < 4; ++round) {
      std::vector<int> order(kBlock * kBlock);
      for (int i = 0; i < kBlock * kBlock; ++i) {
        order[std::size_t(i)] = i;
        std::swap(order[std::size_t(i)], order[random.below(std::uint64_t(i) + 1)]);
      }
      for (int number : order) {
        const auto job = source->start(request(number));
        while (job->progress() == TeProgress::Working) {
          TeAllowance allowance = TeAllowance::units(round == 0 ? 1 : round * 5);
          job->step(allowance);
        }
        const TeHeightMap map = job->takeMap();
        if (round == 0)
          first[std::size_t(number)] = map;
        ASSERT_TRUE(map == first[std::size_t(number)]) << chain.name();
        rows += kSide;
      }
    }
    if (!source->fits())
      continue;
    for (int number = 0; number < kBlock * kBlock; ++number) {
      if (number % kBlock == kBlock - 1)
        continue;
      const TeHeightMap& west = first[std::size_t(number)];
      const TeHeightMap& east = first[std::size_t(number + 1)];
      for (int y = 0; y < kSide; ++y)
        ASSERT_EQ(0, std::memcmp(west.row(y) + kSide / 2, east.row(y), (kSide / 2 + 1) * sizeof(float)))
            << chain.name();
    }
  }
  std::printf("%ld rows equal whatever the order and the slices\n", rows);
}
