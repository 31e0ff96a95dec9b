#include "generators/base/TeArcTangent.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

TEST(TeArcTangent, AgreesWithLongDoubleInEveryDirection) {
  TeRandom random(1, 2, {});
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(-1, 1) * std::ldexp(1.0, int(random.below(40)));
    const double y = random.uniform(-1, 1) * std::ldexp(1.0, int(random.below(40)));
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, double(std::fabs(exact - static_cast<long double>(teAtan2(y, x)))));
  }
  std::printf("largest error %.3g radians\n", worst);
  EXPECT_LT(worst, 5e-16);
}

TEST(TeArcTangent, KnowsTheAxes) {
  const double pi = 0x1.921fb54442d18p+1;
  EXPECT_EQ(teAtan2(0, 0), 0);
  EXPECT_EQ(teAtan2(0, 3), 0);
  EXPECT_EQ(teAtan2(0, -3), pi);
  EXPECT_EQ(teAtan2(5, 0), pi / 2);
  EXPECT_EQ(teAtan2(-5, 0), -pi / 2);
  EXPECT_EQ(teAtan2(2, 2), pi / 4);
}
