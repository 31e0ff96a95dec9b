#include "generators/noise/TeNoiseSettings.h"

#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(TeNoiseSettings, DefaultsAreUsable) { EXPECT_TRUE(TeNoiseSettings().check().ok()); }

TEST(TeNoiseSettings, NumbersOutOfRangeAreRefusedBeforeASourceIsMade) {
  TeNoiseSettings settings[5];
  settings[0].wavelength = double(NAN);
  settings[1].amplitude = double(INFINITY);
  settings[2].octaves = TeNoiseSettings::kMaxOctaves + 1;
  settings[3].warpOctaves = 0;
  settings[4].gain = -0.1;
  for (const TeNoiseSettings& s : settings) {
    EXPECT_FALSE(s.check().ok());
    EXPECT_FALSE(TeNoiseSource::create(s).ok());
  }
}

TEST(TeNoiseSettings, EveryParameterIsBoundToItsMember) {
  TeNoiseSettings settings;
  const TeParameters parameters = settings.parameters();
  ASSERT_TRUE(teSetParameter(parameters, "noise", "octaves", "5").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "wavelength", "123.5").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "amplitude", "6").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "lacunarity", "1.5").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "gain", "0.25").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "sharpness", "3").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "warp", "0.5").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "warp-octaves", "4").ok());
  ASSERT_TRUE(teSetParameter(parameters, "noise", "seed", "18446744073709551615").ok());
  EXPECT_EQ(settings.octaves, 5);
  EXPECT_EQ(settings.wavelength, 123.5);
  EXPECT_EQ(settings.amplitude, 6);
  EXPECT_EQ(settings.lacunarity, 1.5);
  EXPECT_EQ(settings.gain, 0.25);
  EXPECT_EQ(settings.sharpness, 3);
  EXPECT_EQ(settings.warp, 0.5);
  EXPECT_EQ(settings.warpOctaves, 4);
  EXPECT_EQ(settings.seed, ~std::uint64_t(0));
}
