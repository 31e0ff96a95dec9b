#include "generators/filters/TeMatrixFilter.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/filters/TeMatrix.h"
#include "tests/generators/TeTestSources.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

TeResult<TeHeightSourcePtr> over(TeHeightSourcePtr input, const std::string& coefficients, int size = 3) {
  TeMatrixFilter filter;
  filter.coefficients = coefficients;
  filter.size = size;
  return filter.apply(std::move(input));
}

TeHeightMap filtered(const TeHeightMap& map, const std::string& coefficients, int size = 3) {
  const auto source = over(std::make_shared<TeGivenMap>(map), coefficients, size).value();
  return source->generate(TeMapRequest::standalone(map.width(), map.height(), 1, 0).value()).value();
}

/// The definition, sample by sample.
float plain(const TeHeightMap& map, const TeMatrix& matrix, int x, int y) {
  if (TeHeightMap::isMissing(map.at(x, y)))
    return TeHeightMap::missing();
  double sum = 0;
  double used = 0;
  for (int dy = -matrix.radius(); dy <= matrix.radius(); ++dy)
    for (int dx = -matrix.radius(); dx <= matrix.radius(); ++dx) {
      const int column = x + dx;
      const int row = y + dy;
      if (column < 0 || row < 0 || column >= map.width() || row >= map.height() ||
          TeHeightMap::isMissing(map.at(column, row)))
        continue;
      sum += matrix.at(dx, dy) * double(map.at(column, row));
      used += matrix.at(dx, dy);
    }
  return float(sum / used);
}

} // namespace

TEST(TeMatrixFilter, IsTheWeightedMeanOfTheSamplesAtHand) {
  for (int side : {1, 3, 5, 7, 31})
    for (bool holes : {false, true}) {
      TeHeightMap map = teRandomMap(40, 33, std::uint64_t(side));
      if (holes)
        tePunchHoles(map, 4, 5);
      const TeHeightMap result = filtered(map, "gauss", side);
      const TeMatrix matrix = TeMatrix::gauss(side).value();
      for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
          const float expected = plain(map, matrix, x, y);
          ASSERT_EQ(0, std::memcmp(&expected, &result.row(y)[x], sizeof expected)) << x << " " << y;
        }
    }
}

TEST(TeMatrixFilter, RowsAreNorthOffsetsAndColumnsEastOffsets) {
  const TeHeightMap map = teRandomMap(5, 5, 1);
  const TeHeightMap west = filtered(map, "0 0 0  1 1e-3 0  0 0 0");
  EXPECT_NEAR(west.at(2, 2), (map.at(1, 2) + 1e-3 * map.at(2, 2)) / 1.001, 1e-4);
  const TeHeightMap south = filtered(map, "0 1 0  0 1e-3 0  0 0 0");
  EXPECT_NEAR(south.at(2, 2), (map.at(2, 1) + 1e-3 * map.at(2, 2)) / 1.001, 1e-4);
}

TEST(TeMatrixFilter, AFlatMapStaysAsItIs) {
  TeHeightMap map = TeHeightMap::create(40, 20).value();
  map.shift(0.1f);
  tePunchHoles(map, 4, 9);
  EXPECT_TRUE(filtered(map, "box", 5) == map);
  EXPECT_TRUE(filtered(map, "gauss", 9) == map);
  EXPECT_TRUE(filtered(map, "0 -1 0 -1 5 -1 0 -1 0") == map);
}

TEST(TeMatrixFilter, OverAFittingSourceItFitsToo) {
  const auto source = over(TeGeneratorRegistry::instance().source("function").value(), "gauss", 5).value();
  EXPECT_TRUE(source->fits());
  EXPECT_TRUE(source->pointEvaluable());
  const TeLattice lattice = TeLattice::create(33, 2).value();
  const TeHeightMap west = source->generate(TeMapRequest::sourceMap(lattice, 1, {4, -7})).value();
  const TeHeightMap east = source->generate(TeMapRequest::sourceMap(lattice, 1, {5, -7})).value();
  for (int y = 0; y < 33; ++y)
    for (int x = 16; x < 33; ++x)
      ASSERT_EQ(west.at(x, y), east.at(x - 16, y));
}

TEST(TeMatrixFilter, OverAMapOfItsOwnItIsCutAtTheBorder) {
  const auto source = over(std::make_shared<TeGivenMap>(teRandomMap(9, 9, 3)), "box").value();
  EXPECT_FALSE(source->fits());
  EXPECT_TRUE(source->pointEvaluable());
  const auto band = TeGeneratorRegistry::instance().source("function", {"band", "matrix"}).value();
  EXPECT_FALSE(band->fits());
  EXPECT_FALSE(band->pointEvaluable());
  EXPECT_FALSE(over(band, "box").value()->pointEvaluable());
}

TEST(TeMatrixFilter, CoefficientsThatCancelOutAreAnError) {
  const auto given = std::make_shared<TeGivenMap>(teRandomMap(9, 9, 3));
  const auto function = TeGeneratorRegistry::instance().source("function").value();
  // Edge detection: no sum to divide by.
  EXPECT_FALSE(over(given, "-1 -1 -1 -1 8 -1 -1 -1 -1").ok());
  // Cancels only where the eastern column is cut off.
  const std::string lopsided = "0 0 0  -1 1 1  0 0 0";
  EXPECT_FALSE(over(given, lopsided).ok());
  EXPECT_TRUE(over(function, lopsided).ok());
  EXPECT_FALSE(over(given, "0").ok());
}

TEST(TeMatrixFilter, WrongCoefficientsAreOneClearError) {
  const auto given = std::make_shared<TeGivenMap>(teRandomMap(9, 9, 3));
  std::string tooMany;
  for (int i = 0; i < 1000; ++i)
    tooMany += "1 ";
  for (const std::string& text : {std::string(""), std::string("1 2"), std::string("1 2 3 4"),
                                  std::string("1 2 3 4 5 6 7 8 x"), std::string("1 2 3 4 nan 6 7 8 9"),
                                  std::string("1 2 3 4 inf 6 7 8 9"), std::string("1,1,1"), tooMany}) {
    const auto result = over(given, text);
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(result.error().message.rfind("matrix: coefficients", 0), 0u) << result.error().message;
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
  }
  EXPECT_FALSE(over(given, "box", 4).ok());
  EXPECT_FALSE(over(given, "box", 33).ok());
  EXPECT_FALSE(over(given, "box", 0).ok());
}

TEST(TeMatrixFilter, SizesWhoseMarginIsTooLargeAreAnError) {
  const auto source = over(TeGeneratorRegistry::instance().source("function").value(), "box", 5).value();
  EXPECT_TRUE(source->accepts(1, 1).ok());
  EXPECT_TRUE(source->accepts(16380, 16380).ok());
  EXPECT_FALSE(source->accepts(16384, 16384).ok());
}
