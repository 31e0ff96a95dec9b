#include "tests/generators/TeEveryGenerator.h"
#include "tests/generators/TeTestSources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

// 10 km in one cell: filters with weights that are not negative stay between the two levels, and the step is
// only ever made gentler.
TEST(HardCase, CliffsGenerators) {
  constexpr float kHeight = 10000;
  constexpr int kSide = 65;
  TeHeightMap cliff = TeHeightMap::create(kSide, kSide).value();
  ASSERT_TRUE(cliff.fill(kHeight, {32, 0, 33, kSide}).ok());
  const auto given = std::make_shared<TeGivenMap>(cliff);
  for (const char* specification : {"band", "band:k=0.1,passes=1", "band:k=0", "matrix",
                                    "matrix:coefficients=gauss,size=5", "matrix:size=31"}) {
    const auto filter = TeGeneratorRegistry::instance().filter(specification).value();
    const auto source = filter->apply(given).value();
    const TeHeightMap map = source->generate(TeMapRequest::standalone(kSide, kSide, 1, 0).value()).value();
    float steepest = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        ASSERT_TRUE(std::isfinite(map.at(x, y)));
        ASSERT_GE(map.at(x, y), 0.0f);
        ASSERT_LE(map.at(x, y), kHeight * 1.00001f) << specification;
        if (x > 0) {
          steepest = std::max(steepest, map.at(x, y) - map.at(x - 1, y));
          ASSERT_GE(map.at(x, y), map.at(x - 1, y) - 0.01f) << specification;
        }
      }
    EXPECT_LE(steepest, kHeight);
    std::printf("%-34s steepest step %.1f m\n", specification, double(steepest));
  }
  // The same as a function: a step between two samples.
  const auto function =
      TeGeneratorRegistry::instance().source("function:z=\"10000*max(0, min(1, floor(x/32)))\"").value();
  const TeHeightMap map = function->generate(TeMapRequest::standalone(kSide, 3, 1, 0).value()).value();
  EXPECT_EQ(map.at(31, 1), 0.0f);
  EXPECT_EQ(map.at(32, 1), kHeight);
}
