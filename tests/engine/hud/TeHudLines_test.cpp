#include "engine/hud/TeHudLines.h"

#include "engine/TeStatistics.h"
#include "engine/objects/TeObject.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using testing::Contains;
using testing::HasSubstr;

class Balloon : public TeObject {
public:
  Balloon() : TeObject("balloon") {}
  std::vector<std::string> hudLines() const override { return {"gas  80 %"}; }
};

TEST(TeHudLines, SayWhereTheObjectIsHowItMovesAndWhatTheEngineDoes) {
  Balloon balloon;
  ASSERT_TRUE(balloon.setPosition({12.34, -5, 100}));
  ASSERT_TRUE(balloon.setVelocity({3, 4, 0}));
  TeStatistics statistics;
  statistics.heightAboveGround = 42.5;
  statistics.frameSeconds = 0.04;
  statistics.budgetSeconds = 0.004;
  statistics.patches.drawn = 8;
  statistics.patches.block = 9;
  const std::vector<std::string> lines = teHudLines(balloon, statistics);
  EXPECT_THAT(lines, Contains(HasSubstr("balloon")));
  EXPECT_THAT(lines, Contains(HasSubstr("12.3  -5.0  100.0 m")));
  EXPECT_THAT(lines, Contains(HasSubstr("(5.0)"))) << "the speed";
  EXPECT_THAT(lines, Contains(HasSubstr("42.5 m")));
  EXPECT_THAT(lines, Contains(HasSubstr("40.0 ms")));
  EXPECT_THAT(lines, Contains(HasSubstr("8 of 9")));
  EXPECT_THAT(lines, Contains(HasSubstr("0.00 px")));
  EXPECT_THAT(lines, Contains("gas  80 %")) << "the object's own lines";
}

TEST(TeHudLines, SayWhatTheAccuracyIsAndCosts) {
  Balloon balloon;
  TeStatistics statistics;
  const std::size_t before = teHudLines(balloon, statistics).size();
  statistics.frameSeconds = 0.0123;
  statistics.frameGoalSeconds = 1.0 / 60;
  statistics.pixelError = 1.25;
  statistics.errorBoundPixels = 0.8;
  statistics.drawing.triangles = 1412000;
  statistics.drawing.seconds = 0.0098;
  const std::vector<std::string> lines = teHudLines(balloon, statistics);
  EXPECT_EQ(lines.size(), before + 1);
  EXPECT_THAT(lines, Contains(HasSubstr("12.3 of 16.7 ms")));
  EXPECT_THAT(lines, Contains(HasSubstr("0.80 px")));
  EXPECT_THAT(lines, Contains(HasSubstr("1.25 px wanted")));
  EXPECT_THAT(lines, Contains(HasSubstr("1,412,000 triangles")));
  EXPECT_THAT(lines, Contains(HasSubstr("9.8 ms")));
}

TEST(TeHudLines, UnknownGroundIsSaid) {
  Balloon balloon;
  TeStatistics statistics;
  statistics.heightAboveGround = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(teHudLines(balloon, statistics), Contains(HasSubstr("unknown")));
}

TEST(TeHudLines, NothingIsMinusZero) {
  Balloon balloon;
  ASSERT_TRUE(balloon.setPosition({-0.01, -0.0, 0.01}));
  ASSERT_TRUE(balloon.setVelocity({-0.04, 0, -0.0}));
  TeStatistics statistics;
  statistics.heightAboveGround = -1e-9;
  for (const std::string& line : teHudLines(balloon, statistics))
    EXPECT_EQ(line.find("-0.0"), std::string::npos) << line;
}

TEST(TeHudLines, HugeNumbersAreCutNotOverrun) {
  Balloon balloon;
  ASSERT_TRUE(balloon.setPosition({1e300, -1e300, 1e300}));
  for (const std::string& line : teHudLines(balloon, TeStatistics()))
    EXPECT_LT(line.size(), 400u);
}

} // namespace
