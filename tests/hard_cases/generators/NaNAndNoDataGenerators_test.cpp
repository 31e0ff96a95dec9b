#include "tests/generators/TeEveryGenerator.h"
#include "tests/generators/TeTestSources.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>

namespace {

const float kInfinity = std::numeric_limits<float>::infinity();

bool isTheMissingValue(float height) {
  const float missing = TeHeightMap::missing();
  return std::memcmp(&height, &missing, sizeof height) == 0;
}

/// Finite samples, or the one value that stands for a missing one.
testing::AssertionResult isClean(const TeHeightMap& map) {
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      if (!std::isfinite(map.at(x, y)) && !isTheMissingValue(map.at(x, y)))
        return testing::AssertionFailure() << "sample " << x << " " << y << " is " << map.at(x, y);
  return testing::AssertionSuccess();
}

} // namespace

// Each of the usual no-data values goes through the operations of maps: numbers stay numbers, whatever is not
// finite becomes a missing sample.
TEST(HardCase, NaNAndNoDataGenerators) {
  int operations = 0;
  const float values[] = {std::nanf("7"), -std::nanf("1"), kInfinity, -kInfinity, -32768.0f,  FLT_MAX,
                          -FLT_MAX,       999.0f,          0.0f,      -0.0f,      FLT_MIN / 2};
  for (float value : values)
    for (float other : values) {
      TeHeightMap source = teRandomMap(9, 7, 1);
      source.at(4, 3) = value;
      const TeMapRect all = source.bounds();
      TeHeightMap start = TeHeightMap::create(9, 7).value();
      start.at(4, 3) = other;
      using Operation = std::function<TeStatus(TeHeightMap&)>;
      const Operation all_operations[] = {
          [&](TeHeightMap& m) { return m.copy(source, all, all); },
          [&](TeHeightMap& m) { return m.add(source, all, all); },
          [&](TeHeightMap& m) { return m.subtract(source, all, all); },
          [&](TeHeightMap& m) { return m.multiply(source, all, all); },
          [&](TeHeightMap& m) { return m.addScaled(source, 2.0f, all, all); },
          [&](TeHeightMap& m) { return m.addScaled(source, value, all, all); },
          [&](TeHeightMap& m) { return m.fill(value, all); },
          [&](TeHeightMap& m) { return m.scale(value, all); },
      };
      for (const Operation& operation : all_operations) {
        TeHeightMap map = start;
        ASSERT_TRUE(operation(map).ok());
        ASSERT_TRUE(isClean(map));
        ++operations;
      }
      if (std::isfinite(value)) {
        TeHeightMap map = start;
        ASSERT_TRUE(map.copy(source, all, all).ok());
        EXPECT_EQ(map.at(4, 3), value) << "a number that some files use for no data is a number here";
      }
    }

  // Through the filters a hole keeps its place, and no neighbour is spoilt.
  for (const char* specification : {"band", "matrix", "matrix:coefficients=gauss,size=7"}) {
    TeHeightMap map = teRandomMap(33, 33, 2);
    tePunchHoles(map, 3, 6);
    const auto filter = TeGeneratorRegistry::instance().filter(specification).value();
    const auto source = filter->apply(std::make_shared<TeGivenMap>(map)).value();
    const TeHeightMap result = source->generate(TeMapRequest::standalone(33, 33, 1, 0).value()).value();
    EXPECT_TRUE(isClean(result));
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 33; ++x)
        ASSERT_EQ(TeHeightMap::isMissing(result.at(x, y)), TeHeightMap::isMissing(map.at(x, y)))
            << specification << " " << x << " " << y;
    ++operations;
  }

  // A function outside its domain leaves holes.
  for (const char* z : {"sqrt(x - 10)", "1/x", "0/0", "log(x - 5)", "1e30*exp(x)", "(0-x)^0.5"}) {
    const auto source =
        TeGeneratorRegistry::instance().source("function:z=\"" + std::string(z) + "\"").value();
    const TeHeightMap map = source->generate(TeMapRequest::standalone(100, 2, 1, 0).value()).value();
    EXPECT_TRUE(isClean(map)) << z;
    EXPECT_TRUE(map.hasMissing()) << z;
    ++operations;
  }
  std::printf("%d operations: every sample finite or missing\n", operations);
}
