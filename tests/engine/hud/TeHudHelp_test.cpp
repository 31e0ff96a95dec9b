#include "engine/hud/TeHudHelp.h"

#include "engine/camera/TeCameraRig.h"
#include "engine/objects/TeAircraft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace {

using testing::Contains;
using testing::EndsWith;
using testing::StartsWith;

TEST(TeHudHelp, ListsKeysOfObjectCameraEngineAndProgramWithMeaningsBelowEachOther) {
  const std::vector<std::string> lines = teHudHelp(TeAircraft("mine"), TeCameraRig(), {"F12, G  picture"});
  std::size_t column = 0;
  for (const char* meaning : {"faster, slower", "first or third person", "this help", "picture"}) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const std::string& one) {
      return one.find(meaning) != std::string::npos;
    });
    ASSERT_NE(line, lines.end()) << meaning;
    EXPECT_THAT(*line, EndsWith(meaning));
    column = column == 0 ? line->find(meaning) : column;
    EXPECT_EQ(line->find(meaning), column) << meaning;
  }
  EXPECT_THAT(lines.front(), StartsWith("Up/Down, R/F  "));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), ""), 3) << "between the four parts";
}

TEST(TeHudHelp, LeavesLinesWithoutKeysAsTheyAre) {
  class Guide : public TeObject {
  public:
    Guide() : TeObject("guide") {}
    std::vector<std::string> helpLines() const override { return {"(flies by itself)", "trailing  ", ""}; }
  };
  const std::vector<std::string> lines = teHudHelp(Guide(), TeCameraRig(), {});
  EXPECT_THAT(lines, Contains("(flies by itself)"));
  EXPECT_THAT(lines, Contains("trailing  "));
}

TEST(TeHudHelp, AnObjectWithoutKeysAddsNothing) {
  EXPECT_THAT(teHudHelp(TeObject("tower"), TeCameraRig(), {}).front(), StartsWith("C, F2"));
}

} // namespace
