#include "generators/base/TeMath.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

/// Error of a result in units of its last place.
double error(double result, long double exact) {
  const double rounded = double(exact);
  if (!std::isnormal(rounded))
    return 0;
  const double unit = std::ldexp(1.0, std::ilogb(rounded) - 52);
  return double(std::fabs((long double)(result)-exact) / unit);
}

template <class Ours, class Exact, class Argument>
double worst(Ours ours, Exact exact, Argument argument, int count) {
  TeRandom random(2026, 11, {1, 2});
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const double x = argument(random);
    largest = std::max(largest, error(ours(x), exact((long double)(x))));
  }
  return largest;
}

/// Any finite number, all exponents alike.
double anyDouble(TeRandom& random) {
  const double size = std::ldexp(1.0 + random.uniform(), int(random.below(2044)) - 1022);
  return random.below(2) ? size : -size;
}

} // namespace

TEST(TeMath, AnglesNearAndFarAreWithinTheStatedError) {
  const auto near = [](TeRandom& r) { return r.uniform(-100.0, 100.0); };
  const auto middle = [](TeRandom& r) { return r.uniform(-0x1p21, 0x1p21); };
  for (double e : {worst(teSin, sinl, near, 300000), worst(teCos, cosl, near, 300000),
                   worst(teSin, sinl, middle, 300000), worst(teCos, cosl, middle, 300000),
                   worst(teSin, sinl, anyDouble, 200000), worst(teCos, cosl, anyDouble, 200000)}) {
    std::printf("error %.3f units of the last place\n", e);
    EXPECT_LT(e, 2.5);
  }
}

TEST(TeMath, TheDoubleNearestToAMultipleOfHalfPiKeepsItsDigits) {
  // The hardest argument for the reduction (Muller, Elementary Functions, 2006).
  const double hardest = std::ldexp(6381956970095103.0, 797);
  EXPECT_LT(error(teCos(hardest), cosl((long double)(hardest))), 2.5);
  EXPECT_NE(teCos(hardest), 0.0);
}

TEST(TeMath, ExponentialsAndLogarithmsAreWithinTheStatedError) {
  const double e = worst(
      teExp, expl, [](TeRandom& r) { return r.uniform(-708.0, 709.5); }, 300000);
  const double eSmall = worst(
      teExp, expl, [](TeRandom& r) { return r.uniform(-1.0, 1.0); }, 300000);
  const double l = worst(
      teLog, logl, [](TeRandom& r) { return std::fabs(anyDouble(r)); }, 300000);
  const double lOne = worst(
      teLog, logl, [](TeRandom& r) { return r.uniform(0.5, 2.0); }, 300000);
  const double t = worst(
      teTanh, tanhl, [](TeRandom& r) { return r.uniform(-3.0, 3.0); }, 300000);
  const double tSmall = worst(
      teTanh, tanhl, [](TeRandom& r) { return r.uniform(-0.01, 0.01); }, 300000);
  std::printf("exp %.3f %.3f, log %.3f %.3f, tanh %.3f %.3f\n", e, eSmall, l, lOne, t, tSmall);
  EXPECT_LT(e, 1.5);
  EXPECT_LT(eSmall, 1.5);
  EXPECT_LT(l, 1.5);
  EXPECT_LT(lOne, 1.5);
  EXPECT_LT(t, 3.0);
  EXPECT_LT(tSmall, 3.0);
}

TEST(TeMath, PowersKeepTheirRelativeError) {
  TeRandom random(5, 5, {});
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(0.001, 1000.0);
    const double y = random.uniform(-40.0, 40.0);
    const long double exact = powl(x, y);
    const double allowed = 0x1p-52 * (2 + std::fabs(y * std::log(x)));
    ASSERT_LT(std::fabs((long double)(tePow(x, y)) / exact - 1), allowed) << x << " ^ " << y;
    const int n = int(random.below(21)) - 10;
    ASSERT_LT(std::fabs((long double)(tePow(-x, n)) / powl(-x, n) - 1), 0x1p-52 * (2 + 2 * std::abs(n)));
  }
}

TEST(TeMath, SpecialArgumentsAreDefined) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(teSin(0), 0);
  EXPECT_EQ(teCos(0), 1);
  EXPECT_EQ(teExp(0), 1);
  EXPECT_EQ(teLog(1), 0);
  EXPECT_EQ(teTanh(0), 0);
  EXPECT_TRUE(std::isnan(teSin(inf)) && std::isnan(teCos(-inf)) && std::isnan(teSin(nan)));
  EXPECT_EQ(teExp(1000), inf);
  EXPECT_EQ(teExp(-1000), 0);
  EXPECT_TRUE(std::isnan(teExp(nan)) && std::isnan(teLog(nan)) && std::isnan(teTanh(nan)));
  EXPECT_EQ(teLog(0), -inf);
  EXPECT_TRUE(std::isnan(teLog(-1)));
  EXPECT_EQ(teTanh(inf), 1);
  EXPECT_EQ(teTanh(-inf), -1);
  EXPECT_EQ(tePow(0, 0), 1);
  EXPECT_EQ(tePow(2, 10), 1024);
  EXPECT_EQ(tePow(2, -1), 0.5);
  EXPECT_EQ(tePow(-2, 3), -8);
  EXPECT_EQ(tePow(0, -1), inf);
  EXPECT_TRUE(std::isnan(tePow(-2, 0.5)));
  EXPECT_EQ(tePow(0, 0.5), 0);
}
