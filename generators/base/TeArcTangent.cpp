#include "generators/base/TeArcTangent.h"

#include <cmath>

namespace {

constexpr double kHalfPi = 0x1.921fb54442d18p+0;

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
