#include "generators/base/TeMath.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace {

__extension__ using Wide = unsigned __int128;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHalfPi = 0x1.921fb54442d18p+0;

/// An angle as quadrant·π/2 + rest, |rest| ≤ π/4 up to rounding.
struct Reduced {
  unsigned quadrant;
  double rest;
};

/// π/2 in three parts; a count of quadrants below 2^20 times either of the first two is exact.
Reduced reduceSmall(double x) {
  constexpr double kPart1 = 0x1.921fb544p+0;
  constexpr double kPart2 = 0x1.0b4611a6p-34;
  constexpr double kPart3 = 0x1.3198a2e037073p-69;
  const double count = std::floor(x / kHalfPi + 0.5);
  const double first = x - count * kPart1;
  const double second = count * kPart2;
  const double rest = first - second;
  const double lost = (first - rest) - second;
  return {unsigned(std::int64_t(count) & 3), rest + (lost - count * kPart3)};
}

/// 64 zero bits, then the bits of 2/π behind the point.
constexpr std::uint64_t kTwoOverPi[] = {
    0x0000000000000000, 0xA2F9836E4E441529, 0xFC2757D1F534DDC0, 0xDB6295993C439041, 0xFE5163ABDEBBC561,
    0xB7246E3A424DD2E0, 0x06492EEA09D1921C, 0xFE1DEB1CB129A73E, 0xE88235F52EBB4484, 0xE99C7026B45F7E41,
    0x3991D639835339F4, 0x9C845F8BBDF9283B, 0x1FF897FFDE05980F, 0xEF2F118B5A0A6D1F, 0x6D367ECF27CB09B7,
    0x4F463F669E5FEA2D, 0x7527BAC7EBE5F17B, 0x3D0739F78A5292EA, 0x6BFB5FB11F8D5D08, 0x56033046FC7B6BAB,
    0xF0CFBC209AF4361D};

std::uint64_t twoOverPi(int firstBit) {
  const int word = firstBit / 64;
  const int shift = firstBit % 64;
  if (shift == 0)
    return kTwoOverPi[word];
  return kTwoOverPi[word] << shift | kTwoOverPi[word + 1] >> (64 - shift);
}

/// For |x| ≥ 2^20: x·2/π as a fixed-point number of 192 bits, two of them before the point. The bits of 2/π
/// that make multiples of four quadrants are left out.
Reduced reduceLarge(double x) {
  int exponent;
  const double fraction = std::frexp(std::fabs(x), &exponent);
  const std::uint64_t digits = std::uint64_t(std::ldexp(fraction, 53));
  const int firstBit = exponent - 53 + 62;
  const Wide low = Wide(digits) * twoOverPi(firstBit + 128);
  const Wide middle = Wide(digits) * twoOverPi(firstBit + 64) + (low >> 64);
  const std::uint64_t high = digits * twoOverPi(firstBit) + std::uint64_t(middle >> 64);

  unsigned quadrant = unsigned(high >> 62);
  std::uint64_t top = high << 2 | std::uint64_t(middle) >> 62;
  std::uint64_t next = std::uint64_t(middle) << 2 | std::uint64_t(low) >> 62;
  bool negative = false;
  if (top >> 63) { // nearer to the next quadrant
    ++quadrant;
    negative = true;
    top = ~top;
    next = ~next;
  }
  int scale = -64;
  while (!(top >> 63) && scale > -128) { // no double comes nearer to a whole quadrant than 2^-62
    top = top << 1 | next >> 63;
    next <<= 1;
    --scale;
  }
  double rest = std::ldexp(double(top), scale) * kHalfPi;
  if (negative)
    rest = -rest;
  if (x < 0) {
    rest = -rest;
    quadrant = 4u - quadrant;
  }
  return {quadrant & 3u, rest};
}

Reduced reduce(double x) { return std::fabs(x) < 0x1p20 ? reduceSmall(x) : reduceLarge(x); }

/// Taylor's series; the first term left out is below 2^-63 of the sum.
double sinSeries(double r) {
  const double s = r * r;
  double sum = 1.0 / 355687428096000.0;
  sum = sum * s - 1.0 / 1307674368000.0;
  sum = sum * s + 1.0 / 6227020800.0;
  sum = sum * s - 1.0 / 39916800.0;
  sum = sum * s + 1.0 / 362880.0;
  sum = sum * s - 1.0 / 5040.0;
  sum = sum * s + 1.0 / 120.0;
  sum = sum * s - 1.0 / 6.0;
  return r + r * (s * sum);
}

double cosSeries(double r) {
  const double s = r * r;
  double sum = -1.0 / 6402373705728000.0;
  sum = sum * s + 1.0 / 20922789888000.0;
  sum = sum * s - 1.0 / 87178291200.0;
  sum = sum * s + 1.0 / 479001600.0;
  sum = sum * s - 1.0 / 3628800.0;
  sum = sum * s + 1.0 / 40320.0;
  sum = sum * s - 1.0 / 720.0;
  sum = sum * s + 1.0 / 24.0;
  const double half = 0.5 * s;
  const double whole = 1.0 - half;
  return whole + (((1.0 - whole) - half) + s * s * sum);
}

double sinOf(const Reduced& angle) {
  switch (angle.quadrant) {
  case 0:
    return sinSeries(angle.rest);
  case 1:
    return cosSeries(angle.rest);
  case 2:
    return -sinSeries(angle.rest);
  default:
    return -cosSeries(angle.rest);
  }
}

constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

/// e^x - 1 for |x| ≤ ln 2 / 2.
double expMinusOneSeries(double r) {
  double sum = 1.0 / 87178291200.0;
  sum = sum * r + 1.0 / 6227020800.0;
  sum = sum * r + 1.0 / 479001600.0;
  sum = sum * r + 1.0 / 39916800.0;
  sum = sum * r + 1.0 / 3628800.0;
  sum = sum * r + 1.0 / 362880.0;
  sum = sum * r + 1.0 / 40320.0;
  sum = sum * r + 1.0 / 5040.0;
  sum = sum * r + 1.0 / 720.0;
  sum = sum * r + 1.0 / 120.0;
  sum = sum * r + 1.0 / 24.0;
  sum = sum * r + 1.0 / 6.0;
  sum = sum * r + 0.5;
  return r + r * r * sum;
}

/// x = count·ln 2 + rest.
double reduceByLn2(double x, double& count) {
  count = std::floor(x * 0x1.71547652b82fep+0 + 0.5);
  return (x - count * kLn2High) - count * kLn2Low;
}

double wholePower(double x, int n) {
  double power = 1.0;
  for (unsigned bits = unsigned(n < 0 ? -n : n); bits != 0; bits >>= 1) {
    if (bits & 1u)
      power *= x;
    x *= x;
  }
  return n < 0 ? 1.0 / power : power;
}

} // namespace

double teSin(double radians) { return std::isfinite(radians) ? sinOf(reduce(radians)) : kNaN; }

double teCos(double radians) {
  if (!std::isfinite(radians))
    return kNaN;
  Reduced angle = reduce(radians);
  angle.quadrant = (angle.quadrant + 1u) & 3u;
  return sinOf(angle);
}

double teExp(double x) {
  if (x != x)
    return kNaN;
  if (x > 709.8)
    return kInfinity;
  if (x < -745.2)
    return 0.0;
  double count;
  const double rest = reduceByLn2(x, count);
  return std::ldexp(1.0 + expMinusOneSeries(rest), int(count));
}

double teLog(double x) {
  if (!(x >= 0))
    return kNaN;
  if (x == 0)
    return -kInfinity;
  if (x == kInfinity)
    return x;
  int exponent;
  double m = std::frexp(x, &exponent);
  if (m < 0x1.6a09e667f3bcdp-1) {
    m *= 2.0;
    --exponent;
  }
  // log m = 2 atanh(f/(2+f)), with f taken out of the series so that the rounding of s matters little.
  const double f = m - 1.0;
  const double s = f / (2.0 + f);
  const double q = s * s;
  double sum = 1.0 / 23.0;
  for (int odd = 21; odd >= 3; odd -= 2)
    sum = sum * q + 1.0 / odd;
  const double half = 0.5 * f * f;
  const double correction = s * (half + 2.0 * q * sum);
  const double count = exponent;
  return count * kLn2High - ((half - (correction + count * kLn2Low)) - f);
}

double teTanh(double x) {
  if (x != x)
    return kNaN;
  const double size = std::fabs(x);
  double result = 1.0;
  if (size < 20.0) {
    double count;
    const double rest = reduceByLn2(2.0 * size, count);
    const double scale = std::ldexp(1.0, int(count));
    const double t = (scale - 1.0) + scale * expMinusOneSeries(rest);
    result = t / (t + 2.0);
  }
  return x < 0 ? -result : result;
}

double tePow(double x, double y) {
  if (y == 0)
    return 1.0;
  const bool whole = std::floor(y) == y;
  if (whole && std::fabs(y) <= 1024.0)
    return wholePower(x, int(y));
  if (x < 0 && !whole)
    return kNaN;
  const double size = teExp(y * teLog(std::fabs(x)));
  const bool odd = whole && std::floor(0.5 * y) * 2.0 != y;
  return x < 0 && odd ? -size : size;
}
