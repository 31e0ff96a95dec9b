#include "generators/TeLattice.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TeLattice, RefusesEvenSmallAndHugeMaps) {
  for (int samples : {-1, 0, 3, 4, 64, 66, 16387})
    EXPECT_FALSE(TeLattice::create(samples, 1.0)) << samples;
  EXPECT_TRUE(TeLattice::create(5, 1.0));
  EXPECT_TRUE(TeLattice::create(16385, 1.0));
}

TEST(TeLattice, RefusesSpacingThatIsNotAPositiveNumber) {
  for (double spacing : {0.0, -1.0, double(INFINITY), double(NAN)})
    EXPECT_FALSE(TeLattice::create(65, spacing)) << spacing;
}

TEST(TeLattice, PatchZeroIsCentredOnTheOrigin) {
  const TeLattice lattice = *TeLattice::create(65, 1.0);
  EXPECT_EQ(lattice.position(0), -16.0);
  EXPECT_EQ(lattice.position(32), 16.0);
  EXPECT_EQ(TeLattice::create(67, 1.0)->position(0), -16.5);
}

TEST(TeLattice, SampleBelowInvertsPosition) {
  for (double spacing : {1.0, 0.1, 30.0, 1e-3}) {
    const TeLattice lattice = *TeLattice::create(67, spacing);
    for (std::int64_t sample : {0ll, 1ll, -1ll, 1000003ll, -987654321ll, 1ll << 45, -(1ll << 45)}) {
      double fraction = -1;
      EXPECT_EQ(lattice.sampleBelow(lattice.position(sample), fraction), sample) << spacing;
      EXPECT_EQ(fraction, 0.0);
      const double before = std::nextafter(lattice.position(sample), -INFINITY);
      EXPECT_EQ(lattice.sampleBelow(before, fraction), sample - 1);
      EXPECT_LT(fraction, 1.0);
    }
  }
}

TEST(TeLattice, SampleBelowIsExactAsFarAsDoublesTellSamplesApart) {
  TeRandom random(4, 4, {});
  constexpr std::int64_t kFarthest = std::int64_t(1) << 52;
  for (int i = 0; i < 20000; ++i) {
    const int samples = 5 + 2 * int(random.below(8190));
    const TeLattice lattice = *TeLattice::create(samples, random.uniform(1e-3, 1000));
    const std::int64_t size = kFarthest >> random.below(50);
    const std::int64_t sample = size - std::int64_t(random.below(std::uint64_t(2 * size)));
    double fraction = -1;
    ASSERT_EQ(lattice.sampleBelow(lattice.position(sample), fraction), sample) << samples;
    ASSERT_EQ(fraction, 0.0);
  }
}
