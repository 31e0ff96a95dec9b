#include "generators/midpoint/TeMidpointDisplacement.h"

#include "tests/generators/mapsInParts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using Source = std::shared_ptr<const TeMidpointDisplacement>;

Source make(const std::string& variant, double fall = 0.5) {
  TeMidpointParameters parameters;
  parameters.variant = variant;
  parameters.displacement = 16;
  parameters.fall = fall;
  return *TeMidpointDisplacement::create(parameters);
}

TeMapRequest mapOf(int side, TeMapKey key = {}) {
  TeMapRequest request = *TeMapRequest::standalone(side, side, 1.0, 7);
  request.key = key;
  return request;
}

/// The document's recursion, one square at a time; an edge of two squares waits for both centres, which is
/// why the squares of a level are walked twice.
void levels(const TeMidpointDisplacement& source, const TeMapRequest& request, TeHeightMap& map) {
  const int last = map.width() - 1;
  const TeRandom random = source.random(request);
  double d = source.parameters().displacement;
  const auto displaced = [&](int x, int y, double mean) {
    return float(mean + d * source.displacement(random, std::uint64_t(y * map.width() + x)));
  };
  for (int y : {0, last})
    for (int x : {0, last})
      map.at(x, y) = displaced(x, y, 0);
  for (int side = last; side > 1; side /= 2, d *= source.parameters().fall) {
    const int h = side / 2;
    for (int y = 0; y < last; y += side)
      for (int x = 0; x < last; x += side)
        map.at(x + h, y + h) = displaced(
            x + h, y + h,
            (double(map.at(x, y)) + map.at(x + side, y) + map.at(x, y + side) + map.at(x + side, y + side)) /
                4);
    for (int y = 0; y < last; y += side)
      for (int x = 0; x < last; x += side) {
        const double a = map.at(x, y), b = map.at(x + side, y), c = map.at(x, y + side),
                     d2 = map.at(x + side, y + side);
        const double e = map.at(x + h, y + h);
        map.at(x + h, y) =
            displaced(x + h, y, y == 0 ? (a + b + e) / 3 : (a + b + map.at(x + h, y - h) + e) / 4);
        map.at(x, y + h) =
            displaced(x, y + h, x == 0 ? (e + a + c) / 3 : (map.at(x - h, y + h) + e + a + c) / 4);
        if (x + side == last)
          map.at(last, y + h) = displaced(last, y + h, (e + b + d2) / 3);
        if (y + side == last)
          map.at(x + h, last) = displaced(x + h, last, (c + d2 + e) / 3);
      }
  }
}

} // namespace

TEST(TeMidpointDisplacement, BothVariantsFollowTheDocumentsRecursion) {
  for (const char* variant : {"uniform", "gaussian"})
    for (int side : {2, 3, 5, 9, 65, 129}) {
      const Source source = make(variant);
      TeHeightMap expected = *TeHeightMap::create(side, side);
      levels(*source, mapOf(side), expected);
      EXPECT_EQ(*source->generate(mapOf(side)), expected) << variant << " " << side;
    }
}

TEST(TeMidpointDisplacement, AnySlicingGivesTheSameBits) {
  const Source source = make("gaussian");
  const TeHeightMap whole = *source->generate(mapOf(129));
  for (std::int64_t units : {1, 2, 3})
    expectMapInSlices(*source, mapOf(129), units, whole);
}

TEST(TeMidpointDisplacement, OtherSizesAreAnErrorThatNamesTheNextOne) {
  const Source source = make("uniform");
  for (int side : {2, 3, 5, 9, 17, 33, 65, 129, 16385})
    EXPECT_TRUE(source->accepts(side, side)) << side;
  for (int side = 0; side <= 70; ++side)
    if (side != 2 && side != 3 && side != 5 && side != 9 && side != 17 && side != 33 && side != 65) {
      EXPECT_FALSE(source->accepts(side, side)) << side;
    }
  EXPECT_FALSE(source->accepts(65, 33));
  for (int side : {std::numeric_limits<int>::min(), -1, std::numeric_limits<int>::max()})
    EXPECT_FALSE(source->accepts(side, side)) << side;
  EXPECT_NE(source->accepts(67, 67).error().message.find("129x129"), std::string::npos);
  EXPECT_FALSE(source->generate(*TeMapRequest::standalone(65, 33, 1.0, 7)));
}

TEST(TeMidpointDisplacement, SaysThatItCannotBeEvaluatedAtPoints) {
  const Source source = make("uniform");
  EXPECT_FALSE(source->pointEvaluable());
  const TeMapSample sample;
  float height = 0;
  EXPECT_FALSE(source->evaluate(mapOf(65), &sample, 1, &height));
}

TEST(TeMidpointDisplacement, DisplacementsHaveTheirDistributions) {
  for (const char* variant : {"uniform", "gaussian"}) {
    const Source source = make(variant);
    const TeRandom random = source->random(mapOf(65));
    const int count = 100000;
    double sum = 0, squares = 0, fourth = 0;
    int beyond = 0;
    for (int i = 0; i < count; ++i) {
      const double d = source->displacement(random, std::uint64_t(i));
      sum += d;
      squares += d * d;
      fourth += d * d * d * d;
      beyond += std::fabs(d) > 2 ? 1 : 0;
      EXPECT_LE(std::fabs(d), source->isGaussian() ? 6.0 : 1.0);
    }
    const double variance = source->isGaussian() ? 1.0 : 1.0 / 3;
    EXPECT_NEAR(sum / count, 0, 5 * std::sqrt(variance / count));
    EXPECT_NEAR(squares / count, variance, 0.02 * variance);
    // A normal distribution has 4.55 % beyond two deviations and the kurtosis 3; twelve uniforms have 2.9.
    EXPECT_NEAR(double(beyond) / count, source->isGaussian() ? 0.0455 : 0.0, 0.003);
    EXPECT_NEAR(fourth / squares / squares * count, source->isGaussian() ? 2.9 : 1.8, 0.1);
  }
}

TEST(TeMidpointDisplacement, HeightsStayWithinTheSumOfDisplacements) {
  const Source source = make("uniform");
  for (int k = 0; k < 30; ++k) {
    const TeMapStatistics s = source->generate(mapOf(65, {k, -k}))->statistics();
    EXPECT_LT(std::fmax(std::fabs(s.minimum), s.maximum),
              16 + 16 * 2.0); // corners; d·(1 + 2·(1/2 + 1/4 + …))
    EXPECT_GT(s.maximum - s.minimum, 8);
  }
}

TEST(TeMidpointDisplacement, RefusesParametersOutOfRange) {
  for (double bad : {-1.0, 2e6, double(NAN), double(INFINITY)}) {
    TeMidpointParameters parameters;
    parameters.displacement = bad;
    EXPECT_FALSE(TeMidpointDisplacement::create(parameters));
    parameters = {};
    parameters.fall = bad;
    EXPECT_FALSE(TeMidpointDisplacement::create(parameters));
  }
  TeMidpointParameters parameters;
  parameters.variant = "cauchy";
  EXPECT_FALSE(TeMidpointDisplacement::create(parameters));
}
