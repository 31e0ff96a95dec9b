#include "generators/base/TeAllowance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

TEST(TeAllowance, ChargesWhatIsPaidLater) {
  double now = 5;
  TeAllowance time = TeAllowance::seconds(1.0, [&now] { return now; });
  EXPECT_TRUE(time.charge(0.25, 1000));
  EXPECT_DOUBLE_EQ(time.remainingSeconds(), 0.75);
  EXPECT_DOUBLE_EQ(time.elapsed(), 0);
  now += 0.5;
  EXPECT_TRUE(time.spend());
  EXPECT_FALSE(time.charge(0.25, 1000));
  EXPECT_TRUE(time.exhausted());
  EXPECT_DOUBLE_EQ(time.elapsed(), 0.5);

  TeAllowance units = TeAllowance::units(10);
  EXPECT_TRUE(units.charge(1e9, 4));
  EXPECT_EQ(units.remainingUnits(), 6);
  EXPECT_FALSE(units.charge(0, 7));
  EXPECT_EQ(units.remainingUnits(), 0);
  EXPECT_EQ(units.unitsSpent(), 11);

  TeAllowance unlimited = TeAllowance::unlimited();
  EXPECT_TRUE(unlimited.charge(1e9, 1000));
}

TEST(TeAllowance, SaysWhatIsLeftInItsOwnMeasureOnly) {
  double now = 0;
  const TeAllowance time = TeAllowance::seconds(0.004, [&now] { return now; });
  const TeAllowance units = TeAllowance::units(3);
  EXPECT_FALSE(time.countsUnits());
  EXPECT_TRUE(units.countsUnits());
  EXPECT_FALSE(TeAllowance::unlimited().countsUnits());
  EXPECT_EQ(time.remainingUnits(), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(units.remainingUnits(), 3);
  EXPECT_EQ(units.remainingSeconds(), HUGE_VAL);
  EXPECT_EQ(units.elapsed(), 0);
  now = 0.005;
  EXPECT_DOUBLE_EQ(time.remainingSeconds(), -0.001);
}

TEST(TeAllowance, KnowsItsLongestUnitAndReadsTheClockOncePerSpend) {
  double now = 0;
  int reads = 0;
  TeAllowance allowance = TeAllowance::seconds(1.0, [&] {
    ++reads;
    return now;
  });
  EXPECT_EQ(allowance.longestUnit(), 0);
  for (double unit : {0.01, 0.03, 0.02}) {
    now += unit;
    allowance.spend();
  }
  EXPECT_EQ(reads, 4);
  EXPECT_DOUBLE_EQ(allowance.longestUnit(), 0.03);
  now += 0.5; // something else between two units
  allowance.beginUnit();
  now += 0.01;
  allowance.spend();
  EXPECT_DOUBLE_EQ(allowance.longestUnit(), 0.03);
  EXPECT_EQ(reads, 6);
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
