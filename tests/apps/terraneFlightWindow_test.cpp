// terrane-flight in a window, as far as a display without people can tell.

#include "apps/TeAppRun.h"

#include <fstream>

namespace {

class TerraneFlightWindow : public TeAppRun {
protected:
  TerraneFlightWindow() : TeAppRun("terrane-flight") {}

  void SetUp() override {
    if (teRunChild({"xvfb-run", "--help"}).status != 0)
      GTEST_SKIP() << "no xvfb-run";
  }
  /// Runs a script with a display of its own, in which $FLIGHT is the program.
  TeChildResult runScript(const std::string& script) const {
    return teRunChild({"xvfb-run", "-a", "bash", "-c", script}, 60,
                      {"FLIGHT=" TERRANE_BIN "/terrane-flight --context window --size 320x240 --quiet",
                       "FOLDER=" + scratch("")},
                      {"DISPLAY"});
  }
  nlohmann::json reportIn(const std::string& name) const {
    std::ifstream stream(scratch(name));
    return nlohmann::json::parse(stream, nullptr, false);
  }
};

TEST_F(TerraneFlightWindow, ShowsAsManyFramesAsAskedFor) {
  const TeChildResult result =
      runScript("$FLIGHT --frames 60 --path line --offscreen $FOLDER/a.png --report $FOLDER/a.json");
  ASSERT_EQ(result.status, 0) << result.error;
  const TeResult<TePicture> picture = TePicture::readPng(scratch("a.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, 320);
  EXPECT_EQ(picture->height, 240);
  EXPECT_GT(teGroundShare(*picture), 0.1);
  const nlohmann::json report = reportIn("a.json");
  ASSERT_FALSE(report.is_discarded());
  EXPECT_EQ(report["context"], "window");
  EXPECT_GE(report["frames"], 60);
  EXPECT_GT(report["ticks"], 10);
}

TEST_F(TerraneFlightWindow, IsFlownByKeys) {
  if (teRunChild({"sh", "-c", "command -v xdotool"}).status != 0)
    GTEST_SKIP() << "no xdotool";
  const TeChildResult result =
      runScript("$FLIGHT --report $FOLDER/b.json --record $FOLDER/b.txt --screenshots $FOLDER &\n"
                "xdotool search --sync --onlyvisible --name . > /dev/null; sleep 3; xdotool mousemove 100 "
                "100; sleep 0.3; xdotool keydown a; sleep 1.5; xdotool keyup a\n"
                "xdotool key g; sleep 1; xdotool key Escape; wait $!");
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json report = reportIn("b.json");
  ASSERT_FALSE(report.is_discarded());
  EXPECT_LT(report["position_m"][0], -1) << "turned to the left";
  EXPECT_TRUE(TePicture::readPng(scratch("terrane-flight-001.png")));
  // What was flown in a window repeats without one.
  const TeChildResult replay =
      run({"--context", "osmesa", "--size", "320x240", "--quiet", "--replay", scratch("b.txt"), "--report",
           scratch("c.json"), "--screenshots", scratch("")});
  ASSERT_EQ(replay.status, 0) << replay.error;
  EXPECT_EQ(reportIn("c.json")["position_m"], report["position_m"]);
}

TEST_F(TerraneFlightWindow, APausedFlightCostsNothing) {
  if (teRunChild({"sh", "-c", "command -v xdotool"}).status != 0)
    GTEST_SKIP() << "no xdotool";
  const TeChildResult result = runScript("$FLIGHT --report $FOLDER/d.json &\n"
                                         "xdotool search --sync --onlyvisible --name . > /dev/null; sleep 3; "
                                         "xdotool mousemove 100 100; sleep 0.3; xdotool key p; sleep 2\n"
                                         "cut -d' ' -f14,15 /proc/$!/stat\n"
                                         "sleep 3; cut -d' ' -f14,15 /proc/$!/stat\n"
                                         "xdotool key Escape; wait $!");
  ASSERT_EQ(result.status, 0) << result.error;
  int before[2], after[2];
  ASSERT_EQ(std::sscanf(result.output.c_str(), "%d %d %d %d", &before[0], &before[1], &after[0], &after[1]),
            4)
      << result.output;
  std::printf("CPU time of 3 paused seconds: %d ms\n", 10 * (after[0] + after[1] - before[0] - before[1]));
  EXPECT_LE(after[0] + after[1] - before[0] - before[1], 6);
}

} // namespace
