// terrane-drive as its users meet it.

#include "apps/TeAppRun.h"

namespace {

using Arguments = std::vector<std::string>;

class TerraneDrive : public TeAppRun {
protected:
  TerraneDrive() : TeAppRun("terrane-drive") {}

  /// Frames of a thirtieth of a second, driven by itself.
  TePicture drive(int frames, const Arguments& more = {}) {
    Arguments all = {"--auto", "--frames", std::to_string(frames), "--dt", "0.0333"};
    all.insert(all.end(), more.begin(), more.end());
    return draw(all);
  }
  double figure(const char* name) const { return report()[name].get<double>(); }
};

/// Share of the pixels that are as red as the car.
double redShare(const TePicture& picture) {
  int red = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const TePicture::Pixel pixel = picture.pixel(x, y);
      red += pixel[0] > 110 && pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2];
    }
  return double(red) / (picture.width * picture.height);
}

TEST_F(TerraneDrive, WheelsAreOnTheDrawnSurfaceInEveryFrame) {
  drive(600, {"--radius", "1"});
  EXPECT_LE(figure("worst_wheel_gap_m"), 1e-3);
  EXPECT_EQ(report()["frames_wheels_checked"], 600);
  EXPECT_EQ(report()["frames_wheels_without_ground"], 0);
  EXPECT_EQ(report()["frames_without_ground"], 0);
  EXPECT_GE(report()["borders_crossed"], 3);
  EXPECT_GT(report()["wheels_across_borders"], 0);
  EXPECT_GT(figure("distance_m"), 150);
  EXPECT_GT(figure("worst_wheel_travel_m"), 0.01) << "ground as flat as this shows nothing";
}

TEST_F(TerraneDrive, OnOtherGroundToo) {
  for (const char* generator : {"faults", "circles:height=2", "midpoint:displacement=3"}) {
    drive(150, {"--generator", generator, "--spacing", "1", "--center", "-1000016,77", "--radius", "1"});
    EXPECT_LE(figure("worst_wheel_gap_m"), 1e-3) << generator;
    EXPECT_EQ(report()["frames_wheels_checked"], 150) << generator;
  }
}

TEST_F(TerraneDrive, RunsRepeatForAnyWorkersAndBudget) {
  const TePicture first = drive(120);
  const nlohmann::json state = report()["state_hash"];
  EXPECT_EQ(drive(120), first);
  EXPECT_EQ(report()["state_hash"], state);
  EXPECT_EQ(drive(120, {"--workers", "3"}), first);
  EXPECT_EQ(report()["state_hash"], state);
  EXPECT_EQ(drive(120, {"--units", "300"}), first);
  EXPECT_EQ(report()["state_hash"], state);
  drive(120, {"--seed", "5"});
  EXPECT_NE(report()["state_hash"], state);
}

TEST_F(TerraneDrive, ARecordingReplays) {
  const std::string file = scratch("drive.rec");
  const TePicture recorded = drive(60, {"--record", file});
  const nlohmann::json state = report()["state_hash"];
  EXPECT_EQ(drive(60, {"--replay", file}), recorded);
  EXPECT_EQ(report()["state_hash"], state);
  expectRefused({"--replay", file, "--dt", "0.0333", "--context", "osmesa"}, 2, "auto");
}

TEST_F(TerraneDrive, WithoutADriverItStandsStill) {
  draw({"--frames", "40", "--dt", "0.0333"});
  EXPECT_EQ(figure("distance_m"), 0);
  EXPECT_LE(figure("worst_wheel_gap_m"), 1e-3);
}

TEST_F(TerraneDrive, TheCarIsSeenFromBehindAndFromItsSeat) {
  const TePicture third = drive(30, {"--hud", "off"});
  const TePicture first = drive(30, {"--hud", "off", "--view", "first"});
  EXPECT_GT(redShare(third), 0.0015);
  EXPECT_GT(redShare(first), 0.02) << "its bonnet";
  EXPECT_GT(teDifferingShare(first, third), 0.2);
}

TEST_F(TerraneDrive, SaysWhatItCannotDo) {
  expectRefused({"--generator", "function:z=\"sqrt(-1-x*x)\"", "--context", "osmesa"}, 2, "no ground");
  expectRefused({"--center", "1e300,0", "--context", "osmesa"}, 2, "");
  expectRefused({"--spacing", "-1"}, 2, "--spacing");
  expectRefused({"--autopilot"}, 2, "--autopilot");
}

TEST_F(TerraneDrive, HelpTellsItsOwnDefaults) {
  const TeChildResult result = run({"--help"});
  EXPECT_EQ(result.status, 0);
  for (const char* text : {"--auto", "(default: third)", "(default: 3)", "(default: 2)"})
    EXPECT_NE(result.output.find(text), std::string::npos) << text;
}

} // namespace
