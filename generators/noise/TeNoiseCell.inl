#pragma once

#include "generators/noise/TeNoisePlan.h"

#include <cstdint>
#include <cstring>

/// Gradient noise inside one cell of the lattice; part of TeNoiseLoops.inl, with the rules stated there.
namespace {

constexpr int kFractionBits = 52;
constexpr std::uint64_t kCellFactor = 0x9E3779B97F4A7C15ull;
constexpr std::uint64_t kFractionMask = (std::uint64_t(1) << kFractionBits) - 1;

/// fraction·2^-52, without the conversion that SSE2 and AVX2 lack for 64-bit integers.
inline double toUnit(std::uint64_t fraction) {
  const std::uint64_t bits = fraction | 0x3FF0000000000000ull;
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value - 1.0;
}

inline double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

/// sin(angle·π·2^-31) within 0.0011: a parabola, corrected by its own square.
inline double sineOf(std::int32_t angle) {
  const double a = double(angle);
  const double y = a * (0x1p-29 - 0x1p-60 * __builtin_fabs(a));
  return y * (0.775 + 0.225 * __builtin_fabs(y));
}

inline double sine(std::uint32_t angle) { return sineOf(std::int32_t(angle)); }
inline double cosine(std::uint32_t angle) { return sineOf(std::int32_t(angle + 0x40000000u)); }

/// Hash of a column or row of the lattice, from cell · kCellFactor + seed. A bijection: no two of the 2^64
/// columns have the same.
inline std::uint64_t lineHash(std::uint64_t z) {
  z = (z ^ (z >> 32)) * 0xD6E8FEB86659FD93ull;
  return z ^ (z >> 32);
}

/// Angle of the gradient where a column and a row of the lattice cross.
inline std::uint32_t gradientAngle(std::uint64_t columnHash, std::uint64_t rowHash) {
  const std::uint64_t z = columnHash + rowHash;
  return std::uint32_t(((z ^ (z >> 32)) * 0xBF58476D1CE4E5B9ull) >> 32);
}

/// The gradients at the corners of a cell: south-west, south-east, north-west, north-east.
struct Corners {
  double swX, swY, seX, seY, nwX, nwY, neX, neY;
};

inline Corners corners(std::uint64_t cellX, std::uint64_t cellY, const TeNoiseOctave& octave) {
  const std::uint64_t columnX = cellX * kCellFactor + octave.seedX;
  const std::uint64_t rowY = cellY * kCellFactor + octave.seedY;
  const std::uint64_t west = lineHash(columnX);
  const std::uint64_t east = lineHash(columnX + kCellFactor);
  const std::uint64_t south = lineHash(rowY);
  const std::uint64_t north = lineHash(rowY + kCellFactor);
  const std::uint32_t sw = gradientAngle(west, south);
  const std::uint32_t se = gradientAngle(east, south);
  const std::uint32_t nw = gradientAngle(west, north);
  const std::uint32_t ne = gradientAngle(east, north);
  return {cosine(sw), sine(sw), cosine(se), sine(se), cosine(nw), sine(nw), cosine(ne), sine(ne)};
}

inline double noiseInCell(const Corners& g, double x, double y, double u, double v) {
  const double x1 = x - 1.0;
  const double y1 = y - 1.0;
  const double sw = g.swX * x + g.swY * y;
  const double se = g.seX * x1 + g.seY * y;
  const double nw = g.nwX * x + g.nwY * y1;
  const double ne = g.neX * x1 + g.neY * y1;
  const double west = sw + v * (nw - sw);
  const double east = se + v * (ne - se);
  return west + u * (east - west);
}

} // namespace
