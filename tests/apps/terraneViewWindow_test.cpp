// terrane-view in a window, as far as a display without people can tell.

#include "apps/TeAppRun.h"
#include "apps/TeViewInputs.h"

#include <fstream>

namespace {

class TerraneViewWindow : public TeAppRun {
protected:
  TerraneViewWindow() : TeAppRun("terrane-view") {}

  void SetUp() override {
    if (teRunChild({"xvfb-run", "--help"}).status != 0)
      GTEST_SKIP() << "no xvfb-run";
    TeViewInputs::writeGrid(scratch("hills.asc"), 129, 8, TeViewInputs::hills);
  }
  /// Runs a script with a display of its own, in which $VIEW is the program with a terrain and `use KEY...`
  /// presses keys in its window.
  TeChildResult runScript(const std::string& script) const {
    const std::string use = "use() { for k in \"$@\"; do xdotool key $k; sleep 0.2; done; }\n"
                            "open() { xdotool search --sync --onlyvisible --name . > /dev/null; sleep 2; "
                            "xdotool mousemove 100 100; sleep 0.3; }\n";
    return teRunChild({"xvfb-run", "-a", "bash", "-c", use + script}, 90,
                      {"VIEW=" TERRANE_BIN "/terrane-view --context window --size 320x240 --quiet --dem " +
                           scratch("hills.asc"),
                       "FOLDER=" + scratch("")},
                      {"DISPLAY"});
  }
  static bool hasKeys() { return teRunChild({"sh", "-c", "command -v xdotool"}).status == 0; }
  nlohmann::json reportIn(const std::string& name) const {
    std::ifstream stream(scratch(name));
    return nlohmann::json::parse(stream, nullptr, false);
  }
};

TEST_F(TerraneViewWindow, ShowsTheSameAsWithoutOne) {
  const TeChildResult result =
      runScript("$VIEW --frames 5 --dt 0.1 --offscreen $FOLDER/a.png --report $FOLDER/a.json");
  ASSERT_EQ(result.status, 0) << result.error;
  const TeResult<TePicture> picture = TePicture::readPng(scratch("a.png"));
  ASSERT_TRUE(picture);
  const TePicture other = draw({"--dem", scratch("hills.asc"), "--frames", "5", "--dt", "0.1"});
  // The window has no smoothed edges.
  EXPECT_LT(teDifferingShare(*picture, other, 24), 0.03);
  EXPECT_EQ(reportIn("a.json")["triangles"]["median"], report()["triangles"]["median"]);
}

TEST_F(TerraneViewWindow, IsFlownByKeysAndMouse) {
  if (!hasKeys())
    GTEST_SKIP() << "no xdotool";
  const TeChildResult result = runScript(
      "$VIEW --report $FOLDER/b.json --screenshots $FOLDER --eye 0,-400,200 --look 0,400,200 &\n"
      "open; xdotool keydown Up; sleep 1; xdotool keyup Up; sleep 0.3\n"
      "xdotool mousedown 1 mousemove 130 100; sleep 0.2; xdotool mousemove 180 100 mouseup 1; sleep 0.3\n"
      "use g; sleep 0.5; xdotool key Escape; wait $!");
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json report = reportIn("b.json");
  ASSERT_FALSE(report.is_discarded());
  EXPECT_GT(report["eye_m"][1], -395) << "ahead";
  EXPECT_NEAR(report["eye_m"][2].get<double>(), 200, 1);
  EXPECT_LT(report["direction"][0], -0.1) << "the view follows the mouse, as if one dragged the scene";
  EXPECT_TRUE(TePicture::readPng(scratch("terrane-view-001.png")));
}

TEST_F(TerraneViewWindow, KeysSwitchWhatIsDrawn) {
  if (!hasKeys())
    GTEST_SKIP() << "no xdotool";
  const TeChildResult result =
      runScript("$VIEW --report $FOLDER/c.json --coloring plain &\n"
                "open; use i m t equal w c h F1; sleep 0.5; xdotool key Escape; wait $!");
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json settings = reportIn("c.json")["settings"];
  EXPECT_EQ(settings["instancing"], false);
  EXPECT_EQ(settings["geomorph"], true);
  EXPECT_EQ(settings["colouring"], "height") << "the next one that needs no pictures";
  EXPECT_EQ(settings["precision"], 2.5);
  EXPECT_EQ(settings["wireframe"], true);
  EXPECT_EQ(settings["second_camera"], true);
  const TeChildResult error = runScript("$VIEW --report $FOLDER/d.json --pixel-error 4 &\n"
                                        "open; use period; sleep 0.5; xdotool key Escape; wait $!");
  ASSERT_EQ(error.status, 0) << error.error;
  EXPECT_EQ(reportIn("d.json")["settings"]["pixel_error"], 5);
}

TEST_F(TerraneViewWindow, WhatDoesNotMoveCostsNothing) {
  if (!hasKeys())
    GTEST_SKIP() << "no xdotool";
  const TeChildResult result = runScript("$VIEW & open; sleep 1; cut -d' ' -f14,15 /proc/$!/stat\n"
                                         "sleep 2; cut -d' ' -f14,15 /proc/$!/stat\n"
                                         "xdotool key Escape; wait $!");
  ASSERT_EQ(result.status, 0) << result.error;
  int before[2], after[2];
  ASSERT_EQ(std::sscanf(result.output.c_str(), "%d %d %d %d", &before[0], &before[1], &after[0], &after[1]),
            4)
      << result.output;
  EXPECT_LE(after[0] + after[1] - before[0] - before[1], 6) << "in units of 10 ms";
}

} // namespace
