#include "generators/base/TeTrigonometry.h"

#include <cmath>
#include <cstdint>

namespace {

// pi/2 as a sum of three; the first two have 31 bits, so that a quadrant number times each is exact.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a4p-34;
constexpr double kHalfPi3 = 0x1.13198a2e03707p-65;
constexpr double kHalfPi = 0x1.921fb54442d18p+0;

// Taylor polynomials on [-pi/4, pi/4]; the first term left out is below 1e-17.
double sinPolynomial(double a) {
  const double z = a * a;
  double sum = -1.0 / 1307674368000.0;
  sum = sum * z + 1.0 / 6227020800.0;
  sum = sum * z - 1.0 / 39916800.0;
  sum = sum * z + 1.0 / 362880.0;
  sum = sum * z - 1.0 / 5040.0;
  sum = sum * z + 1.0 / 120.0;
  sum = sum * z - 1.0 / 6.0;
  return a + a * z * sum;
}

double cosPolynomial(double a) {
  const double z = a * a;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * z - 1.0 / 87178291200.0;
  sum = sum * z + 1.0 / 479001600.0;
  sum = sum * z - 1.0 / 3628800.0;
  sum = sum * z + 1.0 / 40320.0;
  sum = sum * z - 1.0 / 720.0;
  sum = sum * z + 1.0 / 24.0;
  sum = sum * z - 0.5;
  return 1.0 + z * sum;
}

// The sine of angle + quadrants · pi/2.
double sine(double angle, std::int64_t quadrants) {
  const double turns = std::floor(angle / kHalfPi + 0.5);
  const double rest = ((angle - turns * kHalfPi1) - turns * kHalfPi2) - turns * kHalfPi3;
  switch ((std::int64_t(turns) + quadrants) & 3) {
  case 0:
    return sinPolynomial(rest);
  case 1:
    return cosPolynomial(rest);
  case 2:
    return -sinPolynomial(rest);
  default:
    return -cosPolynomial(rest);
  }
}

// atan(i / 8).
constexpr double kAtanEighths[9] = {0x0.0p+0,
                                    0x1.fd5ba9aac2f6ep-4,
                                    0x1.f5b75f92c80ddp-3,
                                    0x1.6f61941e4def1p-2,
                                    0x1.dac670561bb4fp-2,
                                    0x1.1e00babdefeb4p-1,
                                    0x1.4978fa3269ee1p-1,
                                    0x1.700a7c5784634p-1,
                                    0x1.921fb54442d18p-1};

// Arc tangent of y / x for 0 ≤ y ≤ x, 0 < x: the nearest eighth's, and a Taylor polynomial for the rest.
double atanOfRatio(double y, double x) {
  const int eighth = int(8 * (y / x) + 0.5);
  const double c = eighth * 0.125;
  const double t = (y - c * x) / (x + c * y);
  const double z = t * t;
  double sum = 1.0 / 13.0;
  sum = sum * z - 1.0 / 11.0;
  sum = sum * z + 1.0 / 9.0;
  sum = sum * z - 1.0 / 7.0;
  sum = sum * z + 1.0 / 5.0;
  sum = sum * z - 1.0 / 3.0;
  return kAtanEighths[eighth] + (t + t * z * sum);
}

} // namespace

double teSin(double angle) { return sine(angle, 0); }
double teCos(double angle) { return sine(angle, 1); }

double teAtan2(double y, double x) {
  const double ay = std::fabs(y);
  const double ax = std::fabs(x);
  if (ax == 0 && ay == 0)
    return 0;
  double angle = ay <= ax ? atanOfRatio(ay, ax) : kHalfPi - atanOfRatio(ax, ay);
  if (x < 0)
    angle = 2 * kHalfPi - angle;
  return y < 0 ? -angle : angle;
}
