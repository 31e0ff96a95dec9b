#pragma once

#include "generators/noise/TeNoiseKernel.h"

#include <cstdint>
#include <cstring>

/// The loops of gradient noise, for inclusion by the TeNoiseKernel*.cpp alone: plain loops over arrays that
/// the compiler turns into vectors of whatever width the including file is compiled for. Nothing here may
/// depend on that width (kLanes, which the including file defines), and no function with external linkage may
/// be called or instantiated: the linker could then give an AVX body to a program on a processor without AVX.
namespace {

constexpr int kBlock = 256; ///< samples worked on together; their arrays fit the first-level cache
constexpr int kFractionBits = 52;
constexpr std::uint64_t kCellFactor = 0x9E3779B97F4A7C15ull;
constexpr std::uint64_t kFractionMask = (std::uint64_t(1) << kFractionBits) - 1;

std::uint64_t cellOf(TeNoiseCoordinate coordinate) { return std::uint64_t(coordinate >> 64); }
std::uint64_t fractionOf(TeNoiseCoordinate coordinate) {
  return std::uint64_t(coordinate) >> (64 - kFractionBits);
}

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

/// Where the samples of a block are: in a row, or anywhere.
struct Samples {
  int count;
  bool row;
  std::int64_t firstX, firstY; ///< of a row
  const std::int64_t* halfX;   ///< of samples anywhere
  const std::int64_t* halfY;
};

TeNoiseCoordinate coordinateX(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY) {
  return TeNoiseCoordinate(halfX) * octave.along + TeNoiseCoordinate(halfY) * octave.across + octave.offsetX;
}
TeNoiseCoordinate coordinateY(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY) {
  return TeNoiseCoordinate(halfY) * octave.along - TeNoiseCoordinate(halfX) * octave.across + octave.offsetY;
}

/// Coordinates of a block's samples in one octave.
struct Positions {
  std::uint64_t cellX[kBlock], cellY[kBlock];
  std::uint64_t fractionX[kBlock], fractionY[kBlock]; ///< in 2^-kFractionBits
};

void locate(const Samples& samples, const TeNoiseOctave& octave, Positions& at) {
  TeNoiseCoordinate x = coordinateX(octave, samples.firstX, samples.firstY);
  TeNoiseCoordinate y = coordinateY(octave, samples.firstX, samples.firstY);
  for (int j = 0; j < samples.count; ++j) {
    if (!samples.row) {
      x = coordinateX(octave, samples.halfX[j], samples.halfY[j]);
      y = coordinateY(octave, samples.halfX[j], samples.halfY[j]);
    }
    at.cellX[j] = cellOf(x);
    at.cellY[j] = cellOf(y);
    at.fractionX[j] = fractionOf(x);
    at.fractionY[j] = fractionOf(y);
    x += 2 * octave.along;
    y -= 2 * octave.across;
  }
}

/// Raw noise of an octave at any positions.
void noiseAt(const Positions& at, const TeNoiseOctave& octave, int count, double* __restrict noise) {
  for (int j = 0; j < count; ++j) {
    const double x = toUnit(at.fractionX[j]);
    const double y = toUnit(at.fractionY[j]);
    noise[j] = noiseInCell(corners(at.cellX[j], at.cellY[j], octave), x, y, fade(x), fade(y));
  }
}

/// Where a coordinate that grows by less than a cell a sample enters new cells. Without branches: they would
/// be mispredicted at every other cell.
class Crossings {
public:
  Crossings(std::uint64_t fraction, std::uint64_t step, std::uint64_t count) : m_step(step) {
    const std::uint64_t inCell = step == 0 ? count : ~std::uint64_t(0) / step;
    const std::uint64_t first = step == 0 ? count : ~fraction / step + 1;
    m_perCell = inCell < count ? inCell : count;
    m_next = first < count ? first : count;
    m_fraction = fraction + m_next * step;
  }

  /// The first sample in the next cell.
  std::uint64_t next() const { return m_next; }
  /// Goes on to the cell after that, if this is where sample j is.
  std::uint64_t passIf(bool here) {
    const std::uint64_t mask = 0 - std::uint64_t(here);
    const std::uint64_t advance = m_perCell * m_step;
    const std::uint64_t oneMore = m_fraction + advance >= m_fraction;
    m_next += (m_perCell + oneMore) & mask;
    m_fraction += (advance + (m_step & (0 - oneMore))) & mask;
    return here;
  }

private:
  std::uint64_t m_step;
  std::uint64_t m_perCell; ///< samples in a cell: this many, or one more
  std::uint64_t m_next;
  std::uint64_t m_fraction; ///< at sample m_next
};

/// Cells that a block's row passes through, and the samples in each.
struct Passage {
  int cells = 0;
  int first[kBlock + 1];
  std::uint64_t x[kBlock], y[kBlock];
};

/// Raw noise of an octave along a row, x growing and y falling by less than a cell a sample: the gradients of
/// a cell are computed once for all its samples.
void noiseInRow(const Samples& samples, const TeNoiseOctave& octave, double* __restrict noise) {
  const TeNoiseCoordinate startX = coordinateX(octave, samples.firstX, samples.firstY);
  const TeNoiseCoordinate startY = coordinateY(octave, samples.firstX, samples.firstY);
  const std::uint64_t fractionX = std::uint64_t(startX);
  const std::uint64_t fractionY = std::uint64_t(startY);
  const std::uint64_t stepX = std::uint64_t(2 * octave.along);
  const std::uint64_t stepY = std::uint64_t(2 * octave.across);
  const std::uint64_t count = std::uint64_t(samples.count);

  Passage passage;
  Crossings eastward(fractionX, stepX, count);
  Crossings southward(~fractionY, stepY, count); // falls as its complement grows
  std::uint64_t cellX = cellOf(startX);
  std::uint64_t cellY = cellOf(startY);
  for (std::uint64_t j = 0; j < count;) {
    passage.first[passage.cells] = int(j);
    passage.x[passage.cells] = cellX;
    passage.y[passage.cells] = cellY;
    ++passage.cells;
    const std::uint64_t x = eastward.next();
    const std::uint64_t y = southward.next();
    j = x < y ? x : y;
    cellX += eastward.passIf(x == j);
    cellY -= southward.passIf(y == j);
  }
  passage.first[passage.cells] = samples.count;

  double g[8][kBlock];
  for (int i = 0; i < passage.cells; ++i) {
    const Corners c = corners(passage.x[i], passage.y[i], octave);
    g[0][i] = c.swX;
    g[1][i] = c.swY;
    g[2][i] = c.seX;
    g[3][i] = c.seY;
    g[4][i] = c.nwX;
    g[5][i] = c.nwY;
    g[6][i] = c.neX;
    g[7][i] = c.neY;
  }

  // Vectors run over the end of a cell's samples; the next cell's then overwrite what they left there.
  double x[kBlock + kLanes], y[kBlock + kLanes], u[kBlock + kLanes], v[kBlock + kLanes];
  for (int j = 0; j < samples.count + kLanes; ++j) {
    x[j] = toUnit((fractionX + std::uint64_t(j) * stepX) >> (64 - kFractionBits));
    y[j] = toUnit((fractionY - std::uint64_t(j) * stepY) >> (64 - kFractionBits));
    u[j] = fade(x[j]);
    v[j] = fade(y[j]);
  }
  for (int i = 0; i < passage.cells; ++i) {
    const Corners c{g[0][i], g[1][i], g[2][i], g[3][i], g[4][i], g[5][i], g[6][i], g[7][i]};
    for (int j = passage.first[i]; j < passage.first[i + 1]; j += kLanes)
      for (int k = 0; k < kLanes; ++k)
        noise[j + k] = noiseInCell(c, x[j + k], y[j + k], u[j + k], v[j + k]);
  }
}

/// Raw noise of an octave at a block's samples; room for kLanes more.
void noiseOf(const Samples& samples, const TeNoiseOctave& octave, double* noise) {
  // Cells that a row enters per half sample, as a 64-bit fraction, and up to where it pays to share them.
  constexpr std::uint64_t kWorthSharing = kLanes < 8 ? 0x5000000000000000u : 0x3000000000000000u;
  const bool share = octave.along < kWorthSharing && octave.across < kWorthSharing &&
                     octave.along + octave.across < kWorthSharing;
  if (samples.row && share) {
    noiseInRow(samples, octave, noise);
  } else {
    Positions at;
    locate(samples, octave, at);
    noiseAt(at, octave, samples.count, noise);
  }
}

void fbm(const Samples& samples, const TeNoiseOctave* octaves, int octaveCount, double* __restrict sums) {
  double noise[kBlock + kLanes];
  for (int j = 0; j < samples.count; ++j)
    sums[j] = 0;
  for (int k = 0; k < octaveCount; ++k) {
    noiseOf(samples, octaves[k], noise);
    const double amplitude = octaves[k].amplitude;
    for (int j = 0; j < samples.count; ++j)
      sums[j] += amplitude * noise[j];
  }
}

void ridged(const Samples& samples, const TeNoisePlan& plan, double* __restrict sums) {
  double noise[kBlock + kLanes];
  double weights[kBlock];
  for (int j = 0; j < samples.count; ++j) {
    sums[j] = plan.base;
    weights[j] = 1;
  }
  const double sharpness = plan.sharpness;
  for (int k = 0; k < plan.octaveCount; ++k) {
    noiseOf(samples, plan.octaves[k], noise);
    const double amplitude = plan.octaves[k].amplitude;
    for (int j = 0; j < samples.count; ++j) {
      const double fold = 1.0 - __builtin_fabs(TeNoisePlan::kUnit * noise[j]);
      const double signal = fold * fold * weights[j];
      const double weight = sharpness * signal;
      sums[j] += amplitude * signal;
      weights[j] = weight < 1.0 ? weight : 1.0;
    }
  }
}

/// Moves one coordinate of positions by a·perA + b·perB cells; less than 2^51.
void displace(std::uint64_t* __restrict cell, std::uint64_t* __restrict fraction, const double* __restrict a,
              double perA, const double* __restrict b, double perB, int count) {
  // Adding this leaves a number, rounded to an integer, in the low bits: the conversion that SSE2 and AVX2
  // lack.
  constexpr double kRounder = 0x1.8p52;
  constexpr std::uint64_t kRounderBits = 0x4338000000000000ull;
  constexpr std::uint64_t kOneCell = std::uint64_t(1) << kFractionBits;
  for (int j = 0; j < count; ++j) {
    const double cells = a[j] * perA + b[j] * perB;
    const double wholeInBits = cells + kRounder;
    const double part = cells - (wholeInBits - kRounder); // exact, at most half a cell either way
    const double partInBits = part * 0x1p50 + kRounder;
    std::uint64_t wholeBits;
    std::uint64_t partBits;
    std::memcpy(&wholeBits, &wholeInBits, sizeof wholeBits);
    std::memcpy(&partBits, &partInBits, sizeof partBits);
    // A cell more, so that the sum is positive and its shift a floor.
    const std::uint64_t sum = fraction[j] + ((partBits - kRounderBits) << (kFractionBits - 50)) + kOneCell;
    cell[j] += (wholeBits - kRounderBits) + (sum >> kFractionBits) - 1;
    fraction[j] = sum & kFractionMask;
  }
}

void warped(const Samples& samples, const TeNoisePlan& plan, double* __restrict sums) {
  double eastward[kBlock];
  double northward[kBlock];
  fbm(samples, plan.warpX, plan.warpOctaveCount, eastward);
  fbm(samples, plan.warpY, plan.warpOctaveCount, northward);
  Positions at;
  double noise[kBlock + kLanes];
  for (int j = 0; j < samples.count; ++j)
    sums[j] = 0;
  for (int k = 0; k < plan.octaveCount; ++k) {
    const TeNoiseOctave& octave = plan.octaves[k];
    locate(samples, octave, at);
    displace(at.cellX, at.fractionX, eastward, octave.alongMetre, northward, octave.acrossMetre,
             samples.count);
    displace(at.cellY, at.fractionY, northward, octave.alongMetre, eastward, -octave.acrossMetre,
             samples.count);
    noiseAt(at, octave, samples.count, noise);
    for (int j = 0; j < samples.count; ++j)
      sums[j] += octave.amplitude * noise[j];
  }
}

void heightsOf(const Samples& samples, const TeNoisePlan& plan, float* heights) {
  double sums[kBlock];
  switch (plan.type) {
  case TeNoiseType::Fbm:
    fbm(samples, plan.octaves, plan.octaveCount, sums);
    break;
  case TeNoiseType::Ridged:
    ridged(samples, plan, sums);
    break;
  case TeNoiseType::Warp:
    warped(samples, plan, sums);
    break;
  }
  for (int j = 0; j < samples.count; ++j)
    heights[j] = float(sums[j]);
}

void noiseRow(const TeNoisePlan& plan, std::int64_t halfX, std::int64_t halfY, int count, float* heights) {
  for (int first = 0; first < count; first += kBlock) {
    const int block = count - first < kBlock ? count - first : kBlock;
    heightsOf({block, true, halfX + 2 * std::int64_t(first), halfY, nullptr, nullptr}, plan, heights + first);
  }
}

void noisePoints(const TeNoisePlan& plan, const std::int64_t* halfX, const std::int64_t* halfY, int count,
                 float* heights) {
  for (int first = 0; first < count; first += kBlock) {
    const int block = count - first < kBlock ? count - first : kBlock;
    heightsOf({block, false, 0, 0, halfX + first, halfY + first}, plan, heights + first);
  }
}

} // namespace
