#include "nodes/clipmap/TeClipFormat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

TEST(TeClipFormat, SharpFormatsDrawEverySampleAsItIs) {
  for (const TeClipFormat format : {TeClipFormat::Short, TeClipFormat::Float})
    for (int sample = 0; sample < 65536; sample++)
      ASSERT_EQ(teDrawnHeight(std::uint16_t(sample), format), float(sample));
}

TEST(TeClipFormat, SharpFormatsAreNotRounded) {
  for (const TeClipFormat format : {TeClipFormat::Short, TeClipFormat::Float})
    EXPECT_EQ(teDrawnRounding(format), 0);
}

TEST(TeClipFormat, HalvesAreTheNearestOnes) {
  double worst = 0;
  for (int sample = 0; sample < 65536; sample++) {
    const double value = sample / 65535.0;
    const std::uint16_t half = teHalfOfSample(std::uint16_t(sample));
    const double error = std::abs(double(teFloatOfHalf(half)) - value);
    if (half > 0) {
      ASSERT_LE(error, std::abs(double(teFloatOfHalf(std::uint16_t(half - 1))) - value)) << sample;
    }
    ASSERT_LE(error, std::abs(double(teFloatOfHalf(std::uint16_t(half + 1))) - value)) << sample;
    worst =
        std::max(worst, std::abs(double(teDrawnHeight(std::uint16_t(sample), TeClipFormat::Half)) - sample));
  }
  EXPECT_LE(worst, double(teDrawnRounding(TeClipFormat::Half)));
  EXPECT_GT(worst, 15);
  EXPECT_EQ(teHalfOfSample(0), 0);
  EXPECT_EQ(teHalfOfSample(65535), 0x3c00); // 1
  EXPECT_EQ(teDrawnHeight(65535, TeClipFormat::Half), 65535.0f);
  EXPECT_EQ(teFloatOfHalf(0x0001), std::ldexp(1.0f, -24));
  EXPECT_EQ(teFloatOfHalf(0xc000), -2.0f);
}

TEST(TeClipFormat, TexelsHaveTheStatedSize) {
  EXPECT_EQ(teTexelBytes(TeClipFormat::Short), 2);
  EXPECT_EQ(teTexelBytes(TeClipFormat::Half), 2);
  EXPECT_EQ(teTexelBytes(TeClipFormat::Float), 4);
  EXPECT_EQ(teTexelBytes(TeClipFormat::Colour), 4);
  EXPECT_EQ(teTexelScale(TeClipFormat::Half), 65535.0f);
  EXPECT_EQ(teTexelScale(TeClipFormat::Float), 1.0f);
}
