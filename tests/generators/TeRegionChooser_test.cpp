#include "generators/TeRegionChooser.h"

#include "generators/TeGeneratorRegistry.h"

#include <gtest/gtest.h>

namespace {

TeHeightSourcePtr source(const char* specification) {
  return TeGeneratorRegistry::instance().source(specification).value();
}

} // namespace

TEST(TeRegionChooser, TheLastRegionThatHoldsAKeyWins) {
  const auto sea = source("function:z=0");
  const auto land = source("function:z=1");
  const auto peak = source("function:z=2");
  TeRegionChooser chooser(sea);
  EXPECT_EQ(chooser.choose({5, 5}), sea);
  ASSERT_TRUE(chooser.addRectangle({-2, -1}, {3, 4}, land).ok());
  ASSERT_TRUE(chooser.addDisc({0, 0}, 2, peak).ok());
  EXPECT_EQ(chooser.choose({0, 0}), peak);
  EXPECT_EQ(chooser.choose({2, 0}), peak);
  EXPECT_EQ(chooser.choose({-2, 0}), peak);
  EXPECT_EQ(chooser.choose({2, 1}), land);
  EXPECT_EQ(chooser.choose({3, 4}), land);
  EXPECT_EQ(chooser.choose({-2, 4}), land);
  EXPECT_EQ(chooser.choose({-3, 0}), sea);
  EXPECT_EQ(chooser.choose({4, 4}), sea);
  EXPECT_EQ(chooser.choose({0, -3}), sea);
}

TEST(TeRegionChooser, ChequersHaveNoSeamAtTheOrigin) {
  const auto white = source("function:z=0");
  const auto black = source("function:z=1");
  TeRegionChooser chooser(white);
  ASSERT_TRUE(chooser.addChequers(3, black).ok());
  for (std::int64_t y = -12; y < 12; ++y)
    for (std::int64_t x = -12; x < 12; ++x) {
      EXPECT_EQ(chooser.choose({x, y}), chooser.choose({x + 6, y}));
      EXPECT_EQ(chooser.choose({x, y}), chooser.choose({x + 3, y + 3}));
      EXPECT_NE(chooser.choose({x, y}), chooser.choose({x + 3, y}));
    }
  EXPECT_EQ(chooser.choose({0, 0}), black);
  EXPECT_EQ(chooser.choose({-1, 0}), white);
}

TEST(TeRegionChooser, FarKeysDoNotOverflow) {
  const auto sea = source("function:z=0");
  const auto land = source("function:z=1");
  TeRegionChooser chooser(sea);
  const std::int64_t far = TeLattice::kMaxKey;
  ASSERT_TRUE(chooser.addDisc({-far, -far}, far, land).ok());
  EXPECT_EQ(chooser.choose({far, far}), sea);
  EXPECT_EQ(chooser.choose({0, -far}), land);
  EXPECT_EQ(chooser.choose({1, -far}), sea);
  EXPECT_EQ(chooser.choose({INT64_MAX, INT64_MIN}), sea);
}

TEST(TeRegionChooser, AbilitiesAreThoseThatAllSourcesShare) {
  const auto function = source("function");
  TeRegionChooser chooser(function);
  EXPECT_TRUE(chooser.fits());
  EXPECT_TRUE(chooser.pointEvaluable());
  ASSERT_TRUE(chooser.addChequers(2, function).ok());
  EXPECT_TRUE(chooser.fits());
  // Two sources that fit each with itself do not fit each other.
  ASSERT_TRUE(chooser.addDisc({0, 0}, 3, source("function:z=5")).ok());
  EXPECT_FALSE(chooser.fits());
  EXPECT_TRUE(chooser.pointEvaluable());
  const auto filtered = TeGeneratorRegistry::instance().source("function", {"band"}).value();
  ASSERT_TRUE(chooser.addDisc({9, 9}, 1, filtered).ok());
  EXPECT_FALSE(chooser.pointEvaluable());
}

TEST(TeRegionChooser, RegionsThatHoldNothingAreErrors) {
  const auto land = source("function");
  TeRegionChooser chooser(land);
  EXPECT_FALSE(chooser.addRectangle({1, 0}, {0, 0}, land).ok());
  EXPECT_FALSE(chooser.addRectangle({0, 1}, {0, 0}, land).ok());
  EXPECT_FALSE(chooser.addDisc({0, 0}, -1, land).ok());
  EXPECT_FALSE(chooser.addDisc({INT64_MAX, 0}, 1, land).ok());
  EXPECT_FALSE(chooser.addChequers(0, land).ok());
  EXPECT_FALSE(chooser.addChequers(-4, land).ok());
  EXPECT_EQ(chooser.choose({0, 0}), land);
}
