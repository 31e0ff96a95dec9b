#pragma once

#include "generators/noise/TeNoiseKernel.h"
#include "generators/noise/TeNoiseWalk.inl"

#include <cstdint>
#include <cstring>

/// The loops of gradient noise, for inclusion by the TeNoiseKernel*.cpp alone: plain loops over arrays that
/// the compiler turns into vectors of whatever width the including file is compiled for. No result may
/// depend on that width (kLanes, which the including file defines), and no function with external linkage may
/// be called or instantiated: the linker could then give an AVX body to a program on a processor without AVX.
namespace {

/// Samples' places within their cells, and how far the noise has gone over from one side to the other. Filled
/// for kLanes samples more than there are.
struct Fractions {
  double x[kBlock + kLanes], y[kBlock + kLanes];
  double u[kBlock + kLanes], v[kBlock + kLanes];
};

/// Raw noise of an octave for samples that each have a cell of their own.
void noiseAt(const Positions& at, const TeNoiseOctave& octave, int count, double* __restrict noise) {
  for (int j = 0; j < count; ++j) {
    const double x = toUnit(at.fractionX[j]);
    const double y = toUnit(at.fractionY[j]);
    noise[j] = noiseInCell(corners(at.cellX[j], at.cellY[j], octave), x, y, fade(x), fade(y));
  }
}

/// Raw noise of an octave where neighbours share cells: gradients once a cell. Writes kLanes more.
void noiseInCells(const Passage& passage, const Fractions& at, const TeNoiseOctave& octave,
                  double* __restrict noise) {
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
  for (int i = 0; i < passage.cells; ++i) {
    const Corners c{g[0][i], g[1][i], g[2][i], g[3][i], g[4][i], g[5][i], g[6][i], g[7][i]};
    for (int j = passage.first[i]; j < passage.first[i + 1]; j += kLanes)
      for (int k = 0; k < kLanes; ++k)
        noise[j + k] = noiseInCell(c, at.x[j + k], at.y[j + k], at.u[j + k], at.v[j + k]);
  }
}

/// True if a row enters so few cells that it pays to share them: less than this many a half sample, as a
/// 64-bit fraction.
bool fewCells(const TeNoiseOctave& octave, std::uint64_t limit) {
  return octave.along < limit && octave.across < limit && octave.along + octave.across < limit;
}

void noiseInRow(const Samples& samples, const TeNoiseOctave& octave, double* __restrict noise) {
  const TeNoiseCoordinate startX = coordinateX(octave, samples.firstX, samples.firstY);
  const TeNoiseCoordinate startY = coordinateY(octave, samples.firstX, samples.firstY);
  const std::uint64_t stepX = std::uint64_t(2 * octave.along);
  const std::uint64_t stepY = std::uint64_t(2 * octave.across);
  Passage passage;
  walkRow(startX, startY, stepX, stepY, samples.count, passage);
  Fractions at;
  const std::uint64_t fractionX = std::uint64_t(startX);
  const std::uint64_t fractionY = std::uint64_t(startY);
  for (int j = 0; j < samples.count + kLanes; ++j) {
    at.x[j] = toUnit((fractionX + std::uint64_t(j) * stepX) >> (64 - kFractionBits));
    at.y[j] = toUnit((fractionY - std::uint64_t(j) * stepY) >> (64 - kFractionBits));
    at.u[j] = fade(at.x[j]);
    at.v[j] = fade(at.y[j]);
  }
  noiseInCells(passage, at, octave, noise);
}

void noiseOnPath(Positions& positions, const TeNoiseOctave& octave, int count, double* __restrict noise) {
  Passage passage;
  walk(positions, count, passage);
  Fractions at;
  for (int j = count; j < count + kLanes; ++j)
    positions.fractionX[j] = positions.fractionY[j] = 0;
  for (int j = 0; j < count + kLanes; ++j) {
    at.x[j] = toUnit(positions.fractionX[j]);
    at.y[j] = toUnit(positions.fractionY[j]);
    at.u[j] = fade(at.x[j]);
    at.v[j] = fade(at.y[j]);
  }
  noiseInCells(passage, at, octave, noise);
}

/// Raw noise of an octave at a block's samples; room for kLanes more.
void noiseOf(const Samples& samples, const TeNoiseOctave& octave, double* noise) {
  constexpr std::uint64_t kWorthWalking = kLanes < 8 ? 0x5000000000000000u : 0x3000000000000000u;
  if (samples.row && fewCells(octave, kWorthWalking)) {
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
    constexpr std::uint64_t kWorthWalking = std::uint64_t(1) << 60; // 8 samples a cell, undisplaced
    if (samples.row && fewCells(octave, kWorthWalking))
      noiseOnPath(at, octave, samples.count, noise);
    else
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
