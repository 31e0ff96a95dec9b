#include "generators/base/TeAllowance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

int unitsDone(TeAllowance allowance, int most = 1000) {
  int done = 0;
  do
    ++done;
  while (allowance.spend() && done < most);
  return done;
}

} // namespace

TEST(TeAllowance, CountsUnitsAndAlwaysAllowsOne) {
  EXPECT_EQ(unitsDone(TeAllowance::units(5)), 5);
  EXPECT_EQ(unitsDone(TeAllowance::units(1)), 1);
  EXPECT_EQ(unitsDone(TeAllowance::units(0)), 1);
  EXPECT_EQ(unitsDone(TeAllowance::units(-3)), 1);
  EXPECT_EQ(unitsDone(TeAllowance::unlimited()), 1000);
}

TEST(TeAllowance, StopsByTheInjectedClock) {
  double now = 100;
  const auto clock = [&now] { return now += 0.25; };
  EXPECT_EQ(unitsDone(TeAllowance::seconds(1.0, clock)), 4);
  EXPECT_EQ(unitsDone(TeAllowance::seconds(0.0, clock)), 1);
  EXPECT_EQ(unitsDone(TeAllowance::seconds(-1.0, clock)), 1);
  EXPECT_EQ(unitsDone(TeAllowance::seconds(double(NAN), clock)), 1);
}

TEST(TeAllowance, SaysWhatWasSpentAndWhetherMoreMayBe) {
  TeAllowance allowance = TeAllowance::units(10);
  EXPECT_FALSE(allowance.exhausted());
  EXPECT_TRUE(allowance.spend(4));
  EXPECT_FALSE(allowance.spend(6));
  EXPECT_TRUE(allowance.exhausted());
  EXPECT_EQ(allowance.unitsSpent(), 10);
  EXPECT_FALSE(TeAllowance::unlimited().exhausted());
}

TEST(TeAllowance, MeasuresTheThreadsOwnTime) {
  const double before = teThreadCpuSeconds();
  TeAllowance allowance = TeAllowance::seconds(0.002);
  double sum = 0;
  do
    for (int i = 1; i < 1000; ++i)
      sum += 1.0 / i;
  while (allowance.spend());
  EXPECT_GT(sum, 0);
  EXPECT_GE(teThreadCpuSeconds() - before, 0.002);
}
