#include "apps/terrane-accuracy/TeRadialSpectrum.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numeric>

namespace {

using Complex = std::complex<double>;

constexpr double kPi = 3.14159265358979323846;
constexpr double kLeastShare = 1e-12;

int logarithm(int powerOfTwo) {
  int result = 0;
  while ((1 << result) < powerOfTwo)
    ++result;
  return result;
}

/// In place; `step` apart in memory.
void transform(Complex* values, std::size_t count, std::size_t step) {
  for (std::size_t i = 1, j = 0; i < count; ++i) {
    std::size_t bit = count / 2;
    for (; j & bit; bit /= 2)
      j ^= bit;
    j ^= bit;
    if (i < j)
      std::swap(values[i * step], values[j * step]);
  }
  for (std::size_t length = 2; length <= count; length *= 2) {
    const std::size_t half = length / 2;
    for (std::size_t k = 0; k < half; ++k) {
      const Complex turn = std::polar(1.0, -2 * kPi * double(k) / double(length));
      for (std::size_t first = k; first < count; first += length) {
        Complex& a = values[first * step];
        Complex& b = values[(first + half) * step];
        const Complex turned = turn * b;
        b = a - turned;
        a += turned;
      }
    }
  }
}

} // namespace

TeRadialSpectrum::TeRadialSpectrum(int side) : m_side(side), m_power(std::size_t(logarithm(side) - 1)) {
  assert(side >= 4 && (side & (side - 1)) == 0);
}

void TeRadialSpectrum::add(const TeHeightMap& map) {
  const std::size_t side = std::size_t(m_side);
  double mean = 0;
  for (int y = 0; y < m_side; ++y)
    mean = std::accumulate(map.row(y), map.row(y) + m_side, mean);
  mean /= double(side * side);
  std::vector<double> window(side);
  for (std::size_t i = 0; i < side; ++i)
    window[i] = 0.5 - 0.5 * std::cos(2 * kPi * (double(i) + 0.5) / double(side));
  std::vector<Complex> values(side * side);
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x)
      values[y * side + x] = (map.at(int(x), int(y)) - mean) * window[x] * window[y];
  for (std::size_t i = 0; i < side; ++i)
    transform(&values[i * side], side, 1);
  for (std::size_t i = 0; i < side; ++i)
    transform(&values[i], side, side);
  const auto frequency = [this](std::size_t index) {
    const int k = int(index);
    return k < m_side / 2 ? k : k - m_side;
  };
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const double radius = std::hypot(double(frequency(x)), double(frequency(y)));
      const int band = radius < 1 ? -1 : int(std::floor(std::log2(radius)));
      if (band >= 0 && band < bands())
        m_power[std::size_t(band)] += std::norm(values[y * side + x]);
    }
}

std::vector<double> TeRadialSpectrum::shares() const {
  const double sum = std::accumulate(m_power.begin(), m_power.end(), 0.0);
  std::vector<double> shares = m_power;
  for (double& share : shares)
    share = sum > 0 ? share / sum : 0;
  return shares;
}

double TeRadialSpectrum::difference(const std::vector<double>& shares, const std::vector<double>& reference) {
  assert(shares.size() == reference.size());
  double squares = 0;
  int bands = 0;
  for (std::size_t band = 0; band < shares.size(); ++band) {
    if (shares[band] < kLeastShare || reference[band] < kLeastShare)
      continue;
    const double decibels = 10 * std::log10(shares[band] / reference[band]);
    squares += decibels * decibels;
    ++bands;
  }
  return bands > 0 ? std::sqrt(squares / bands) : 0;
}
