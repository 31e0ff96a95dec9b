#include "generators/noise/TeNoiseKernel.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace {

constexpr TeNoiseType kTypes[] = {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp};

/// Wavelengths from far below the spacing to far above it, odd ratios among them.
TeNoiseSettings settingsOf(TeNoiseType type, double wavelength, double lacunarity) {
  TeNoiseSettings settings;
  settings.type = type;
  settings.wavelength = wavelength;
  settings.lacunarity = lacunarity;
  settings.warp = 1;
  return settings;
}

std::vector<float> row(const TeNoiseKernel& kernel, const TeNoisePlan& plan, std::int64_t x, std::int64_t y,
                       int count) {
  std::vector<float> heights(std::size_t(count), -1e30f);
  kernel.row(plan, x, y, count, heights.data());
  return heights;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

} // namespace

TEST(TeNoiseKernel, EveryPathGivesTheSameBits) {
  std::string names;
  for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
    names += std::string(" ") + kernel.name;
  std::printf("paths:%s\n", names.c_str());

  TeRandom random(1, 2, {});
  const TeNoiseKernel& scalar = TeNoiseKernel::available().front();
  for (TeNoiseType type : kTypes)
    for (double wavelength : {0.3, 1.7, 12.0, 200.0, 1e6})
      for (double lacunarity : {1.0, 1.87, 2.0}) {
        const TeNoisePlan plan(settingsOf(type, wavelength, lacunarity), 7, 1.0);
        for (std::int64_t distance : {std::int64_t(0), std::int64_t(1) << 40, std::int64_t(1) << 61}) {
          const int count = 1 + int(random.below(700));
          const std::int64_t x = distance - 301;
          const std::int64_t y = 77 - distance;
          const std::vector<float> expected = row(scalar, plan, x, y, count);
          for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
            EXPECT_TRUE(sameBits(row(kernel, plan, x, y, count), expected))
                << kernel.name << " type " << int(type) << " wavelength " << wavelength << " lacunarity "
                << lacunarity << " at " << distance;
        }
      }
}

TEST(TeNoiseKernel, EveryTilingOfARowGivesTheSameBits) {
  constexpr int kCount = 1500;
  TeRandom random(3, 4, {});
  for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
    for (TeNoiseType type : kTypes) {
      const TeNoisePlan plan(settingsOf(type, 90.0, 2.1), 7, 1.0);
      const std::int64_t x = -(std::int64_t(1) << 50) - 13;
      const std::vector<float> whole = row(kernel, plan, x, 5, kCount);
      for (int attempt = 0; attempt < 4; ++attempt) {
        std::vector<float> pieces;
        while (int(pieces.size()) < kCount) {
          const int first = int(pieces.size());
          const int count = std::min(kCount - first, 1 + int(random.below(attempt < 2 ? 20 : 600)));
          const std::vector<float> piece = row(kernel, plan, x + 2 * first, 5, count);
          pieces.insert(pieces.end(), piece.begin(), piece.end());
        }
        EXPECT_TRUE(sameBits(pieces, whole)) << kernel.name << " type " << int(type);
      }
    }
}

TEST(TeNoiseKernel, ScatteredPointsHaveTheBitsOfTheRow) {
  constexpr int kCount = 600;
  TeRandom random(5, 6, {});
  for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
    for (TeNoiseType type : kTypes)
      for (double wavelength : {0.7, 300.0}) {
        const TeNoisePlan plan(settingsOf(type, wavelength, 2.0), 7, 1.0);
        const std::int64_t x = (std::int64_t(1) << 58) + 3;
        const std::vector<float> whole = row(kernel, plan, x, -9, kCount);
        std::vector<std::int64_t> halfX, halfY(333, -9);
        for (int i = 0; i < 333; ++i)
          halfX.push_back(x + 2 * std::int64_t(random.below(kCount)));
        std::vector<float> heights(halfX.size());
        kernel.points(plan, halfX.data(), halfY.data(), int(halfX.size()), heights.data());
        for (std::size_t i = 0; i < halfX.size(); ++i)
          ASSERT_EQ(heights[i], whole[std::size_t(halfX[i] - x) / 2]) << kernel.name;
      }
}

TEST(TeNoiseKernel, WritesNothingBeyondTheRow) {
  for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
    for (int count : {1, 3, 7, 255, 256, 257}) {
      std::vector<float> heights(std::size_t(count) + 16, 123.0f);
      kernel.row(TeNoisePlan(TeNoiseSettings(), 1, 1.0), 0, 0, count, heights.data());
      for (std::size_t i = std::size_t(count); i < heights.size(); ++i)
        ASSERT_EQ(heights[i], 123.0f) << kernel.name << " " << count;
    }
}
