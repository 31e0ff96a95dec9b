#include "generators/noise/TeNoisePlan.h"

#include "generators/base/TeRandom.h"
#include "generators/noise/TeNoiseKernel.h"
#include "generators/noise/TeNoiseReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

struct Agreement {
  double worstUlp = 0;  ///< of the heights above 10^-7 of the amplitude
  double worstTiny = 0; ///< of the others, in amplitudes
  int rounded = 0;      ///< heights that are the float nearest to the reference
  int samples = 0;
};

/// Compares rows of samples that start at random places near (halfX, halfY).
Agreement compare(const TeNoiseSettings& settings, std::int64_t half, double spacing, int rows) {
  constexpr int kRow = 48;
  const TeNoiseReference reference(settings, 11, spacing);
  const TeNoisePlan plan(settings, 11, spacing);
  TeRandom random(5, std::uint64_t(half), {});
  Agreement agreement;
  for (int r = 0; r < rows; ++r) {
    const std::int64_t x = half + std::int64_t(random.below(20000)) - 10000;
    const std::int64_t y = -half + std::int64_t(random.below(20000)) - 10000;
    std::vector<float> heights(kRow);
    TeNoiseKernel::best().row(plan, x, y, kRow, heights.data());
    for (int i = 0; i < kRow; ++i) {
      const TeQuad exact = reference.height(x + 2 * i, y);
      const double error = std::fabs(double(TeQuad(heights[std::size_t(i)]) - exact));
      const double size = std::fabs(double(exact));
      const float nearest = float(exact);
      agreement.rounded += nearest == heights[std::size_t(i)];
      ++agreement.samples;
      if (size < 1e-7 * settings.amplitude) {
        agreement.worstTiny = std::max(agreement.worstTiny, error / settings.amplitude);
      } else {
        const float magnitude = std::fabs(nearest);
        const double ulp = double(magnitude) - double(std::nextafter(magnitude, 0.0f));
        agreement.worstUlp = std::max(agreement.worstUlp, error / ulp);
      }
    }
  }
  return agreement;
}

const char* typeName(TeNoiseType type) {
  return type == TeNoiseType::Fbm ? "fbm" : type == TeNoiseType::Ridged ? "ridged" : "warp";
}

} // namespace

TEST(TeNoisePlan, HeightsAreWithinTheLastBitAtEveryDistance) {
  for (TeNoiseType type : {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp})
    for (double distance : {0.0, 1e7, 1e12, 0x1p60}) {
      TeNoiseSettings settings;
      settings.type = type;
      const Agreement a = compare(settings, 2 * std::int64_t(distance), 1.0, 12);
      std::printf(
          "%-6s at %.4g units: at most %.4f ulp from the 128-bit reference, %d of %d correctly rounded\n",
          typeName(type), distance, a.worstUlp, a.rounded, a.samples);
      EXPECT_LE(a.worstUlp, 1.0);
      EXPECT_LE(a.worstTiny, 1e-14);
      EXPECT_GE(a.rounded, a.samples * 99 / 100);
    }
}

TEST(TeNoisePlan, HoldsForOtherSettings) {
  TeNoiseSettings settings;
  settings.type = TeNoiseType::Warp;
  settings.octaves = 12;
  settings.wavelength = 913.7;
  settings.amplitude = 313.3;
  settings.lacunarity = 1.93;
  settings.gain = 0.61;
  settings.warp = 0.85;
  settings.warpOctaves = 5;
  settings.seed = 99;
  for (TeNoiseType type : {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp})
    for (double spacing : {0.37, 30.0}) {
      settings.type = type;
      const Agreement a = compare(settings, 1234567890123, spacing, 4);
      EXPECT_LE(a.worstUlp, 1.0) << typeName(type) << spacing;
      EXPECT_LE(a.worstTiny, 1e-14) << typeName(type) << spacing;
    }
}

TEST(TeNoisePlan, GradientsPointEvenlyAllRound) {
  const TeNoisePlan plan(TeNoiseSettings(), 3, 1.0);
  constexpr int kSectors = 64;
  constexpr int kSide = 256;
  for (const TeNoiseOctave& octave : {plan.octaves[0], plan.octaves[7]}) {
    std::vector<int> counts(kSectors);
    double alongX = 0, alongY = 0, diagonal = 0, square = 0;
    double shortest = 2, longest = 0;
    for (std::uint64_t y = 0; y < kSide; ++y)
      for (std::uint64_t x = 0; x < kSide; ++x) {
        const auto at = [&](std::uint64_t i, std::uint64_t j) {
          return TeNoiseReference::gradient(octave, x + i - kSide / 2, y + j - kSide / 2);
        };
        const auto dot = [](TeNoiseReference::Gradient a, TeNoiseReference::Gradient b) {
          return double(a.x * b.x + a.y * b.y);
        };
        const TeNoiseReference::Gradient g = at(0, 0);
        const double length = std::hypot(double(g.x), double(g.y));
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        const double turn = std::atan2(double(g.y), double(g.x)) / (2 * M_PI) + 0.5;
        ++counts[std::size_t(turn * kSectors) % kSectors];
        alongX += dot(g, at(1, 0));
        alongY += dot(g, at(0, 1));
        diagonal += dot(g, at(1, 1));
        // The sum of two opposite corners against the other two: what an additive hash would betray.
        square += dot(g, at(1, 1)) * dot(at(1, 0), at(0, 1));
      }
    const double points = double(kSide) * kSide;
    double chiSquare = 0;
    for (int count : counts)
      chiSquare += (count - points / kSectors) * (count - points / kSectors) / (points / kSectors);
    std::printf("gradients: chi square %.1f over %d sectors, correlation east %.4f north %.4f diagonal %.4f "
                "square %.4f, length %.5f to %.5f\n",
                chiSquare, kSectors, alongX / points, alongY / points, diagonal / points, square / points,
                shortest, longest);
    EXPECT_LT(chiSquare, 120); // 63 expected; the 99.99 % quantile is 111
    for (double correlation : {alongX, alongY, diagonal, square})
      EXPECT_LT(std::fabs(correlation / points), 4.5 * 0.71 / kSide); // standard deviation 0.71/side
    EXPECT_GT(shortest, 0.9988);
    EXPECT_LT(longest, 1.0012);
  }
}

TEST(TeNoisePlan, OctavesHaveTheirWavelengthAndTurnAwayFromTheAxes) {
  TeNoiseSettings settings;
  settings.wavelength = 317;
  settings.lacunarity = 1.9;
  const double spacing = 7.5;
  const TeNoisePlan plan(settings, 3, spacing);
  double wavelength = settings.wavelength;
  for (int k = 0; k < settings.octaves; ++k) {
    const double east = double(plan.octaves[k].along) * 0x1p-63 / spacing; // cells per metre
    const double north = double(plan.octaves[k].across) * 0x1p-63 / spacing;
    EXPECT_NEAR(wavelength * std::hypot(east, north), 1, 1e-14);
    EXPECT_GT(std::min(east, north) * wavelength, std::sin(7 * M_PI / 180)) << k;
    wavelength /= settings.lacunarity;
  }
}

TEST(TeNoisePlan, AnOctaveDoesNotDependOnTheirNumber) {
  TeNoiseSettings few;
  few.octaves = 3;
  const TeNoisePlan a(few, 3, 1.0);
  const TeNoisePlan b(TeNoiseSettings(), 3, 1.0);
  for (int k = 0; k < few.octaves; ++k) {
    EXPECT_TRUE(a.octaves[k].along == b.octaves[k].along && a.octaves[k].offsetX == b.octaves[k].offsetX);
    EXPECT_EQ(a.octaves[k].seedX, b.octaves[k].seedX);
    for (int other = 0; other < k; ++other)
      EXPECT_NE(b.octaves[k].seedX, b.octaves[other].seedX);
  }
}
