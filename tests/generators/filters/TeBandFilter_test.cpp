#include "generators/filters/TeBandFilter.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/filters/TeBandGrid.h"
#include "generators/filters/TeMatrixFilter.h"
#include "tests/generators/TeTestSources.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// The recursion of the document along one line, sample by sample.
void plainLine(float* first, std::ptrdiff_t step, int count, float k) {
  const float rest = 1.0f - k;
  for (int i = 1; i < count; ++i) {
    const float before = first[(i - 1) * step];
    float& here = first[i * step];
    if (TeHeightMap::isMissing(here) || TeHeightMap::isMissing(before))
      continue;
    const float mixed = before * rest + here * k;
    here = std::isfinite(mixed) ? mixed : TeHeightMap::missing();
  }
}

void plainPass(TeHeightMap& map, float k) {
  const int w = map.width();
  const int h = map.height();
  for (int y = 0; y < h; ++y) {
    plainLine(map.row(y), 1, w, k);
    plainLine(map.row(y) + w - 1, -1, w, k);
  }
  for (int x = 0; x < w; ++x) {
    plainLine(map.row(0) + x, w, h, k);
    plainLine(map.row(h - 1) + x, -w, h, k);
  }
}

TeHeightMap filtered(const TeHeightMap& map, double k, int passes) {
  TeBandFilter filter;
  filter.k = k;
  filter.passes = passes;
  TeHeightSourcePtr source = filter.apply(std::make_shared<TeGivenMap>(map)).value();
  return source->generate(TeMapRequest::standalone(map.width(), map.height(), 1, 0).value()).value();
}

} // namespace

TEST(TeBandFilter, HasTheBitsOfThePlainLoopForEverySize) {
  const int sides[] = {1, 2, 3, 15, 16, 17, 31, 33, 64, 65, 127, 129, 257};
  for (int width : sides)
    for (int height : sides) {
      TeHeightMap expected = teRandomMap(width, height, 5);
      const TeHeightMap result = filtered(expected, 0.9, 2);
      plainPass(expected, 0.9f);
      plainPass(expected, 0.9f);
      ASSERT_TRUE(result == expected) << width << "x" << height;
    }
}

TEST(TeBandFilter, LongLinesInSeveralPiecesHaveTheSameBits) {
  for (const auto& [width, height] : {std::pair(1025, 40), std::pair(40, 1025), std::pair(600, 513)}) {
    TeHeightMap expected = teRandomMap(width, height, 6);
    const TeHeightMap result = filtered(expected, 0.3, 1);
    plainPass(expected, 0.3f);
    ASSERT_TRUE(result == expected) << width << "x" << height;
  }
}

TEST(TeBandFilter, MissingAndHugeHeightsAreHandledLikeInThePlainLoop) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    TeHeightMap expected = teRandomMap(70, 49, seed, seed % 2 ? 3.4e38 : 100.0);
    tePunchHoles(expected, seed, 2 + seed);
    const TeHeightMap result = filtered(expected, 0.7, 3);
    for (int pass = 0; pass < 3; ++pass)
      plainPass(expected, 0.7f);
    ASSERT_TRUE(result == expected) << seed;
  }
}

TEST(TeBandFilter, EveryProcessorKindHasTheSameBits) {
  const TeBandKernel* kinds[] = {&TeBandKernel::baseline, &TeBandKernel::avx2, &TeBandKernel::avx512};
  const int best = TeBandKernel::best().lanes;
  TeHeightMap expected = teRandomMap(300, 147, 9);
  tePunchHoles(expected, 1, 500);
  const TeHeightMap before = expected;
  plainPass(expected, 0.9f);
  for (const TeBandKernel* kind : kinds) {
    if (kind->lanes > best)
      continue;
    TeHeightMap map = before;
    TeBandGrid grid(map.width(), map.height(), *kind);
    grid.load(map, 0, map.height());
    grid.begin(0.9f, 1);
    while (grid.unit()) {
    }
    grid.store(map, 0, map.height());
    EXPECT_TRUE(map == expected) << kind->name;
  }
}

TEST(TeBandFilter, OneChangesNothingAndKeepsTheInputsAbilities) {
  const auto input = TeGeneratorRegistry::instance().source("function").value();
  TeBandFilter filter;
  EXPECT_EQ(filter.k, 0.9);
  EXPECT_EQ(filter.passes, 5);
  EXPECT_FALSE(filter.apply(input).value()->pointEvaluable());
  EXPECT_FALSE(filter.apply(input).value()->fits());
  filter.k = 1;
  EXPECT_EQ(filter.apply(input).value(), input);
  filter.k = 0.5;
  filter.passes = 0;
  EXPECT_EQ(filter.apply(input).value(), input);
}

TEST(TeBandFilter, AFlatMapStaysFlat) {
  TeHeightMap map = TeHeightMap::create(65, 65).value();
  map.shift(1234.5f);
  const TeHeightMap result = filtered(map, 0.9, 5);
  for (int y = 0; y < 65; ++y)
    for (int x = 0; x < 65; ++x)
      ASSERT_NEAR(result.at(x, y), 1234.5f, 0.001f);
}

// One step of the recursion is the matrix with m21 = 1-k and m22 = k over a map whose western samples are
// filtered already.
TEST(TeBandFilter, IsTheMatrixOfTheDocumentAppliedInPlace) {
  const TeHeightMap before = teRandomMap(40, 1, 3);
  TeHeightMap rising = before;
  plainLine(rising.row(0), 1, 40, 0.9f);
  TeMatrixFilter matrix;
  matrix.coefficients = "0 0 0  0.1 0.9 0  0 0 0";
  for (int x = 0; x < 40; ++x) {
    TeHeightMap partly = before;
    ASSERT_TRUE(partly.copy(rising, {0, 0, x + 1, 1}, {0, 0, x + 1, 1}).ok());
    partly.at(x, 0) = before.at(x, 0);
    const auto source = matrix.apply(std::make_shared<TeGivenMap>(partly)).value();
    const TeHeightMap step = source->generate(TeMapRequest::standalone(40, 1, 1, 0).value()).value();
    ASSERT_NEAR(step.at(x, 0), rising.at(x, 0), 1e-4) << x;
  }
}

TEST(TeBandFilter, UnusableParametersAndSizesAreErrors) {
  TeBandFilter filter;
  const auto input = TeGeneratorRegistry::instance().source("function").value();
  for (double k : {-0.1, 1.1, std::nan(""), double(INFINITY)}) {
    filter.k = k;
    const auto result = filter.apply(input);
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().message.find("band: k is"), std::string::npos) << result.error().message;
  }
  filter.k = 0.9;
  const auto source = filter.apply(input).value();
  EXPECT_TRUE(source->accepts(1, 1 << 24).ok());
  EXPECT_FALSE(source->accepts(1, 1 << 25).ok());
  EXPECT_TRUE(source->accepts(16, 1 << 23).ok());
}
