#include "generators/noise/TeNoiseSource.h"

#include "generators/base/TeRandom.h"
#include "tests/generators/mapsInParts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr TeNoiseType kTypes[] = {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp};

TeHeightSourcePtr noise(TeNoiseType type) {
  TeNoiseSettings settings;
  settings.type = type;
  return *TeNoiseSource::create(settings);
}

} // namespace

TEST(TeNoiseSource, AnySlicingGivesTheSameMap) {
  const TeLattice lattice = *TeLattice::create(65, 1.0);
  for (TeNoiseType type : kTypes) {
    const TeHeightSourcePtr source = noise(type);
    const TeMapRequest request = TeMapRequest::sourceMap(lattice, 4, {-3, 8});
    expectMapInSlices(*source, request, 1, *source->generate(request));
  }
}

TEST(TeNoiseSource, OverlappingMapsOfAWorldAgree) {
  const TeLattice lattice = *TeLattice::create(33, 2.0);
  for (TeNoiseType type : kTypes)
    for (std::int64_t key : {std::int64_t(0), std::int64_t(-7), TeLattice::kMaxKey - 1}) {
      const TeHeightMap a = *noise(type)->generate(TeMapRequest::sourceMap(lattice, 4, {key, -key}));
      const TeHeightMap b = *noise(type)->generate(TeMapRequest::sourceMap(lattice, 4, {key + 1, 1 - key}));
      for (int y = 0; y <= 16; ++y)
        for (int x = 0; x <= 16; ++x)
          ASSERT_EQ(a.at(16 + x, 16 + y), b.at(x, y)) << key;
    }
}

TEST(TeNoiseSource, TheLandDoesNotDependOnTheSizeOfItsMaps) {
  const TeMapRequest small = TeMapRequest::sourceMap(*TeLattice::create(65, 1.0), 4, {0, 0});
  const TeMapRequest large = TeMapRequest::sourceMap(*TeLattice::create(129, 1.0), 4, {0, 0});
  const TeHeightMap a = *noise(TeNoiseType::Fbm)->generate(small);
  const TeHeightMap b = *noise(TeNoiseType::Fbm)->generate(large);
  const int shift = int(small.x(0) - large.x(0)); // metres are samples here
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x)
      ASSERT_EQ(a.at(x, y), b.at(x + shift, y + shift));
}

TEST(TeNoiseSource, ScatteredSamplesAndRunsHaveTheBitsOfTheMap) {
  const TeMapRequest request =
      TeMapRequest::sourceMap(*TeLattice::create(301, 1.0), 4, {std::int64_t(1) << 40, -5});
  TeRandom random(8, 8, {});
  for (TeNoiseType type : kTypes) {
    const TeHeightSourcePtr source = noise(type);
    EXPECT_TRUE(source->fits());
    EXPECT_TRUE(source->pointEvaluable());
    const TeHeightMap map = *source->generate(request);
    std::vector<TeMapSample> samples;
    for (int i = 0; i < 777; ++i)
      samples.push_back({int(random.below(301)), int(random.below(301))});
    std::vector<float> heights(samples.size());
    ASSERT_TRUE(source->evaluate(request, samples.data(), samples.size(), heights.data()).ok());
    for (std::size_t i = 0; i < samples.size(); ++i)
      ASSERT_EQ(heights[i], map.at(samples[i].column, samples[i].row));

    std::vector<float> run(100);
    const auto& points = dynamic_cast<const TePointSource&>(*source);
    ASSERT_TRUE(points.evaluateRun(request, {150, 40}, 100, run.data()).ok());
    for (int i = 0; i < 100; ++i)
      ASSERT_EQ(run[std::size_t(i)], map.at(150 + i, 40));
  }
}

TEST(TeNoiseSource, HeightsSpreadOverTheAmplitudeAndNeverBeyond) {
  TeMapRequest request = *TeMapRequest::standalone(512, 512, 20.0, 9);
  for (TeNoiseType type : kTypes)
    for (int octaves : {1, 8}) {
      TeNoiseSettings settings;
      settings.type = type;
      settings.octaves = octaves;
      settings.amplitude = 100;
      const TeHeightMap map = *(*TeNoiseSource::create(settings))->generate(request);
      const TeMapStatistics s = map.statistics();
      double square = 0;
      for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x)
          square += (map.at(x, y) - s.mean) * (map.at(x, y) - s.mean);
      const double deviation = std::sqrt(square / (512 * 512));
      std::printf("type %d, %d octaves, amplitude 100: %.1f to %.1f, mean %.2f, standard deviation %.2f\n",
                  int(type), octaves, double(s.minimum), double(s.maximum), s.mean, deviation);
      EXPECT_GE(s.minimum, -100.0f);
      EXPECT_LE(s.maximum, 100.0f);
      EXPECT_GT(deviation, 15);
      EXPECT_LT(deviation, 50);
      if (type != TeNoiseType::Ridged) {
        EXPECT_LT(std::fabs(s.mean), 1.5); // 2,600 cells of a mean that has no bias
      }
    }
}

TEST(TeNoiseSource, IsAlikeInAllDirections) {
  TeNoiseSettings settings;
  settings.wavelength = 50;
  const TeHeightMap map =
      *(*TeNoiseSource::create(settings))->generate(*TeMapRequest::standalone(1200, 1200, 1.0, 9));
  const auto roughness = [&](int dx, int dy) {
    double sum = 0;
    for (int y = 20; y < 1180; ++y)
      for (int x = 20; x < 1180; ++x) {
        const double step = map.at(x + dx, y + dy) - map.at(x, y);
        sum += step * step;
      }
    return std::sqrt(sum) / 1160;
  };
  const double steps[] = {roughness(5, 0), roughness(4, 3),  roughness(3, 4),
                          roughness(0, 5), roughness(-3, 4), roughness(-4, 3)};
  const double least = *std::min_element(std::begin(steps), std::end(steps));
  const double most = *std::max_element(std::begin(steps), std::end(steps));
  std::printf("mean step over 5 samples in six directions: %.4f to %.4f m\n", least, most);
  EXPECT_LT(most / least, 1.05);
}

TEST(TeNoiseSource, SeedsTypesAndParametersGiveOtherLand) {
  const TeMapRequest request = *TeMapRequest::standalone(33, 33, 1.0, 1);
  TeMapRequest otherWorld = request;
  otherWorld.worldSeed = 2;
  const TeHeightSourcePtr plain = noise(TeNoiseType::Fbm);
  EXPECT_NE(*plain->generate(request), *plain->generate(otherWorld));

  TeNoiseSettings changed[5];
  changed[0].seed = 1;
  changed[1].type = TeNoiseType::Ridged;
  changed[2].octaves = 7;
  changed[3].gain = 0.51;
  changed[4].lacunarity = 2.1;
  for (const TeNoiseSettings& settings : changed) {
    const TeHeightSourcePtr other = *TeNoiseSource::create(settings);
    EXPECT_NE(other->fingerprint(), plain->fingerprint());
    EXPECT_NE(*other->generate(request), *plain->generate(request));
  }
  EXPECT_EQ(noise(TeNoiseType::Fbm)->fingerprint(), plain->fingerprint());
}

TEST(TeNoiseSource, MoreOctavesOnlyAddDetail) {
  TeNoiseSettings few;
  few.octaves = 1;
  TeNoiseSettings more = few;
  more.octaves = 2;
  const TeMapRequest request = *TeMapRequest::standalone(65, 65, 1.0, 1);
  const TeHeightMap a = *(*TeNoiseSource::create(few))->generate(request);
  const TeHeightMap b = *(*TeNoiseSource::create(more))->generate(request);
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x)
      ASSERT_LE(std::fabs(b.at(x, y) - a.at(x, y) / 1.5f), few.amplitude / 3 + 1e-3);
}

TEST(TeNoiseSource, ExtremeSettingsGiveFiniteHeights) {
  for (double wavelength : {0.1, 1e9})
    for (double spacing : {1e-300, 1e-3, 1e300}) {
      TeNoiseSettings settings;
      settings.type = TeNoiseType::Warp;
      settings.octaves = TeNoiseSettings::kMaxOctaves;
      settings.wavelength = wavelength;
      settings.lacunarity = 4;
      settings.gain = 1;
      settings.warp = 16;
      settings.amplitude = 1e6;
      TeMapRequest request = *TeMapRequest::standalone(70, 5, spacing, 1);
      const TeMapStatistics s = (*(*TeNoiseSource::create(settings))->generate(request)).statistics();
      EXPECT_EQ(s.missing, 0);
      EXPECT_LE(s.maximum, 1e6f);
      EXPECT_GE(s.minimum, -1e6f);
    }
}
