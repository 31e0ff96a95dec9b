// What `terrane-accuracy generation` and `normals` measure with: spectra of known waves, plain formulas,
// normals of planes.

#include "apps/terrane-accuracy/TePlainGenerators.h"
#include "apps/terrane-accuracy/TeRadialSpectrum.h"
#include "apps/terrane-accuracy/TeSmoothLand.h"
#include "apps/terrane-accuracy/TeTriangleNormals.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kPi = 3.14159265358979323846;

/// 64² samples of a wave of so many periods across.
TeHeightMap waves(double east, double north) {
  TeHeightMap map = TeHeightMap::create(64, 64).value();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      map.at(x, y) = float(5 + std::sin(2 * kPi * (east * x + north * y) / 64));
  return map;
}

TEST(TeRadialSpectrum, AWaveIsInItsOctave) {
  for (const auto& [east, north, band] :
       {std::tuple(6.0, 0.0, 2), {0.0, 12.0, 3}, {-9.0, 9.0, 3}, {24.0, 3.0, 4}}) {
    TeRadialSpectrum spectrum(64);
    EXPECT_EQ(spectrum.bands(), 5);
    spectrum.add(waves(east, north));
    const std::vector<double> shares = spectrum.shares();
    EXPECT_GT(shares[std::size_t(band)], 0.99) << east << " " << north;
  }
}

TEST(TeRadialSpectrum, DifferencesAreInDecibels) {
  const std::vector<double> a = {0.5, 0.4, 0.1, 0}, b = {0.05, 0.04, 0.01, 0.9};
  EXPECT_EQ(TeRadialSpectrum::difference(a, a), 0);
  EXPECT_NEAR(TeRadialSpectrum::difference(a, b), 10, 1e-9); // what one of them lacks has no part in it
}

/// The plain formulas are those of the generators, which round.
TEST(PlainGenerators, AreThoseOfTheGenerators) {
  const TeMapRequest request = TeMapRequest::standalone(65, 65, 1.0, 3).value();
  const auto expectNear = [](const TeHeightMap& map, const TeDoubleHeights& plain, double share) {
    ASSERT_EQ(plain.size(), map.bytes() / sizeof(float));
    const auto [low, high] = std::minmax_element(plain.begin(), plain.end());
    EXPECT_GT(*high - *low, 1);
    for (std::size_t i = 0; i < plain.size(); ++i)
      ASSERT_NEAR(map.data()[i], plain[i], share * (*high - *low)) << i;
  };
  const auto faults = TeFaultFormation::create({}).value();
  expectNear(faults->generate(request).value(), tePlainFaults(*faults, request), 1e-5);
  const auto circles = TeCircles::create({}).value();
  expectNear(circles->generate(request).value(), tePlainCircles(*circles, request), 1e-5);
  const auto midpoint = TeMidpointDisplacement::create({}).value();
  expectNear(midpoint->generate(request).value(), tePlainMidpoint(*midpoint, request), 1e-6);
}

TEST(TriangleNormals, OfAPlaneAreItsOwn) {
  TeHeightMap map = TeHeightMap::create(17, 17).value();
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 17; ++x)
      map.at(x, y) = float(3 * x - 2 * y);
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-3, 2, 0.5));
  for (const TeNormalWay way : kTeNormalWays)
    for (const int step : {1, 2, 4})
      EXPECT_LT(glm::length(teNormalBy(way, map, 8, 8, step, 0.5) - expected), 1e-6) << teNameOf(way);
}

TEST(TriangleNormals, BlocksHaveThoseOfSingleSamples) {
  const TeHeightMap map = teMountains(33);
  for (const TeNormalWay way : kTeNormalWays)
    for (const int step : {1, 2}) {
      std::vector<glm::vec3> normals(81);
      teNormalsBy(way, map, 8, 25, 2, step, 10, normals.data());
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x)
          ASSERT_LT(glm::length(glm::dvec3(normals[std::size_t(9 * y + x)]) -
                                teNormalBy(way, map, 8 + 2 * x, 8 + 2 * y, step, 10)),
                    1e-6);
    }
}

TEST(SmoothLand, NormalsAreThoseOfItsHeights) {
  const TeSmoothLand land;
  const TeHeightMap map = land.heights(65);
  for (int i = 5; i < 60; i += 7) {
    EXPECT_FLOAT_EQ(map.at(i, 64 - i), float(land.height(i, 64 - i)));
    const glm::dvec3 near = teNormalBy(TeNormalWay::Central, map, i, 64 - i, 1, TeSmoothLand::kSpacing);
    EXPECT_LT(glm::length(near - land.normal(i, 64 - i)), 0.2);
  }
}

} // namespace
