// What flights do: they repeat, they have ground below them, and their report tells.

#include "apps/TeAppRun.h"
#include "engine/input/TeRecorder.h"

#include <fstream>
#include <map>

namespace {

using Arguments = std::vector<std::string>;

class TerraneFlightRuns : public TeAppRun {
protected:
  TerraneFlightRuns() : TeAppRun("terrane-flight") {}

  /// A run with a fixed step.
  TePicture fly(Arguments arguments) {
    arguments.insert(arguments.end(), {"--dt", "0.0333", "--size", "160x120", "--quiet"});
    return draw(std::move(arguments));
  }
  /// A recording of a run without arguments, in which these keys go down.
  std::string recordingOf(const std::map<int, SoKeyboardEvent::Key>& keys, int frames = 60) {
    const std::string plain = scratch("plain"), file = scratch("keys");
    fly({"--frames", "1", "--record", plain});
    TeRecorder::Settings settings;
    std::ifstream stream(plain);
    for (std::string line; std::getline(stream, line) && line != "frames";)
      if (line.rfind("setting ", 0) == 0) {
        const std::size_t blank = line.find(' ', 8);
        settings[line.substr(8, blank - 8)] = blank == std::string::npos ? "" : line.substr(blank + 1);
      }
    const auto recorder = TeRecorder::create(file, settings);
    EXPECT_TRUE(recorder);
    for (int i = 0; i < frames; ++i) {
      TeRecordedFrame frame;
      frame.dt = 0.0333;
      if (const auto found = keys.find(i); found != keys.end())
        frame.keys.push_back({found->second, true, false, false, false});
      (*recorder)->add(frame);
    }
    EXPECT_TRUE((*recorder)->finish());
    return file;
  }
  std::string hashes() const {
    return report()["state_hash"].get<std::string>() + " " + report()["picture_hash"].get<std::string>();
  }
};

TEST_F(TerraneFlightRuns, TheReportSaysWhatWasDone) {
  const TePicture picture = fly({"--seed", "5", "--frames", "40", "--path", "line"});
  EXPECT_GT(teGroundShare(picture), 0.1);
  for (const char* key : {"frames",
                          "budget_ms",
                          "ticks_over_budget",
                          "worst_tick_ms",
                          "median_tick_ms",
                          "frames_without_ground",
                          "frames_with_missing_in_view",
                          "jobs",
                          "patches",
                          "memory_peak_bytes",
                          "redraws",
                          "state_hash",
                          "picture_hash",
                          "context",
                          "seed",
                          "uploads",
                          "teleports",
                          "generator",
                          "ticks",
                          "pixel_error",
                          "error_bound",
                          "triangles",
                          "frame_goal_ms"})
    EXPECT_TRUE(report().contains(key)) << key;
  EXPECT_EQ(report()["frames"], 40);
  EXPECT_EQ(report()["seed"], 5);
  EXPECT_EQ(report()["context"], "osmesa");
  EXPECT_EQ(report()["budget_ms"], 4);
  for (const char* key : {"resident", "drawn", "made", "made_again", "dropped"})
    EXPECT_TRUE(report()["patches"].contains(key)) << key;
  EXPECT_EQ(report()["patches"]["drawn"], 9);
  for (const char* key : {"maps", "heights", "meshes", "buffers", "process"})
    EXPECT_GT(report()["memory_peak_bytes"][key], 0) << key;
  for (const char* kind : {"ground", "block", "ahead", "other"})
    EXPECT_TRUE(report()["jobs"][kind]["now"].contains("source maps")) << kind;
  EXPECT_GT(report()["jobs"]["block"]["finished"], 0);
  EXPECT_GT(report()["uploads"]["count"], 0);
  EXPECT_GT(report()["worst_tick_ms"], 0);
  EXPECT_EQ(report()["pixel_error"], 0);
  EXPECT_EQ(report()["error_bound"], 0);
}

TEST_F(TerraneFlightRuns, AWantedErrorHoldsAndRepeats) {
  const Arguments flight = {"--frames", "40", "--path", "line", "--radius", "3", "--seed", "3"};
  const auto with = [&](const char* pixels) {
    Arguments all = flight;
    all.insert(all.end(), {"--pixel-error", pixels});
    return fly(std::move(all));
  };
  const TePicture full = fly(flight);
  const std::string state = report()["state_hash"];
  std::int64_t triangles = report()["triangles"];
  for (const char* pixels : {"0.5", "2", "8"}) {
    const TePicture picture = with(pixels);
    EXPECT_EQ(report()["state_hash"], state) << "what objects do does not depend on it";
    EXPECT_EQ(report()["pixel_error"], std::atof(pixels));
    EXPECT_LE(report()["error_bound"].get<double>(), std::atof(pixels));
    EXPECT_GT(report()["error_bound"].get<double>(), 0);
    EXPECT_LT(report()["triangles"].get<std::int64_t>(), triangles) << pixels;
    triangles = report()["triangles"];
    const std::string hashes = this->hashes();
    with(pixels);
    EXPECT_EQ(this->hashes(), hashes) << pixels;
  }
}

// By the clock: where every frame is too dear the error grows, and where none is it is the least.
TEST_F(TerraneFlightRuns, AFrameRateChoosesTheError) {
  const auto run = [&](Arguments arguments, const std::string& frames) {
    arguments.insert(arguments.end(), {"--size", "160x120", "--quiet", "--frames", frames, "--radius", "2"});
    return draw(std::move(arguments));
  };
  run({"--fps", "1000"}, "400"); // it grows by so much in a tenth of a second, however fast frames are
  EXPECT_GT(report()["pixel_error"].get<double>(), 1);
  EXPECT_EQ(report()["frame_goal_ms"], 1);
  run({"--fps", "1", "--pixel-error", "2"}, "40");
  EXPECT_NEAR(report()["pixel_error"].get<double>(), 2, 1e-9);
  run({"--fps", "30", "--dt", "0.0333"}, "40");
  EXPECT_EQ(report()["pixel_error"], 0) << "runs that repeat do not go by the clock";
  EXPECT_EQ(report()["frame_goal_ms"], 0);
}

TEST_F(TerraneFlightRuns, StraightFlightAlwaysHasGroundAndAView) {
  for (const char* speed : {"60", "600"}) {
    fly({"--path", "line", "--speed", speed, "--frames", "150"});
    EXPECT_EQ(report()["frames_without_ground"], 0) << speed;
    std::printf("%s m/s: %d of 150 frames with a patch missing in view, worst tick %.2f ms\n", speed,
                report()["frames_with_missing_in_view"].get<int>(), report()["worst_tick_ms"].get<double>());
    EXPECT_EQ(report()["frames_with_missing_later"], 0) << speed << ": only while the first block is made";
    EXPECT_NEAR(report()["path"]["metres"].get<double>(), 150 * 0.0333 * std::stod(speed), 1e-6);
  }
}

TEST_F(TerraneFlightRuns, RunsRepeatWhateverTheWorkersAndTheBudget) {
  const std::string recording = scratch("recording");
  const TePicture first = fly({"--path", "zigzag", "--frames", "90", "--hud", "off", "--record", recording});
  const std::string hash = hashes();
  for (const Arguments& more : std::vector<Arguments>{{"--workers", "0"},
                                                      {"--workers", "1"},
                                                      {"--workers", "4"},
                                                      {"--units", "8"},
                                                      {"--units", "1000"},
                                                      {"--workers", "4", "--units", "8"}}) {
    Arguments arguments = {"--path", "zigzag", "--hud", "off", "--replay", recording};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const TePicture again = fly(arguments); // fails at the first state that differs
    EXPECT_EQ(report()["frames"], 90);
    EXPECT_EQ(hashes(), hash) << testing::PrintToString(more);
    EXPECT_EQ(again, first) << testing::PrintToString(more);
  }
}

TEST_F(TerraneFlightRuns, KeysOfARecordingAreSent) {
  fly({"--replay", recordingOf({}), "--frames", "60"});
  const double straight = report()["position_m"][0], far = report()["position_m"][1];
  EXPECT_EQ(straight, 0);
  fly({"--replay", recordingOf({{5, SoKeyboardEvent::A}})});
  EXPECT_LT(report()["position_m"][0], -5) << "turned to the left";
  fly({"--replay", recordingOf({{5, SoKeyboardEvent::P}})});
  EXPECT_LT(report()["position_m"][1], far / 5) << "paused";
  fly({"--replay", recordingOf({{5, SoKeyboardEvent::ESCAPE}})});
  EXPECT_EQ(report()["frames"], 6);
}

TEST_F(TerraneFlightRuns, F12WritesTheNextFreePicture) {
  std::ofstream(scratch("terrane-flight-002.png")) << "taken";
  const std::string recording = recordingOf({{3, SoKeyboardEvent::F12}, {6, SoKeyboardEvent::G}});
  fly({"--replay", recording, "--screenshots", scratch("")});
  EXPECT_TRUE(TePicture::readPng(scratch("terrane-flight-001.png")));
  EXPECT_TRUE(TePicture::readPng(scratch("terrane-flight-003.png")));
  EXPECT_FALSE(TePicture::readPng(scratch("terrane-flight-004.png")));
}

TEST_F(TerraneFlightRuns, NothingIsDrawnAgainThatDoesNotChange) {
  fly({"--replay", recordingOf({{2, SoKeyboardEvent::P}}, 200)});
  EXPECT_EQ(report()["frames"], 200);
  EXPECT_LT(report()["frames_drawn"], 100);
}

TEST_F(TerraneFlightRuns, JumpsAreFollowedWithinATick) {
  fly({"--path", "teleport", "--frames", "330", "--radius", "4", "--units", "8"});
  EXPECT_EQ(report()["path"]["jumps"], 7);
  EXPECT_EQ(report()["teleports"]["count"], 7);
  EXPECT_GT(report()["jobs"]["block"]["cancelled"].get<int>() +
                report()["jobs"]["ahead"]["cancelled"].get<int>(),
            0);
  std::printf("ground after a jump within %d ticks\n",
              report()["teleports"]["most_ticks_until_ground"].get<int>());
  EXPECT_LE(report()["teleports"]["most_ticks_until_ground"], 3);
  EXPECT_EQ(report()["patches"]["drawn"], 81);
}

TEST_F(TerraneFlightRuns, WaypointsAreFlown) {
  const std::string file = scratch("path.txt");
  std::ofstream(file) << "0 0 +20 50\n100 0 +20\njump 5000 5000 +20\n5100 5000 +20\n";
  fly({"--path", file, "--frames", "130"});
  EXPECT_EQ(report()["path"]["ended"], true);
  EXPECT_NEAR(report()["path"]["metres"].get<double>(), 200, 1e-6);
  EXPECT_EQ(report()["position_m"][0], 5100);
  EXPECT_LE(report()["frames_without_ground"], 3);
}

TEST_F(TerraneFlightRuns, MemoryIsFlatOnceTheBlockIsFull) {
  fly({"--path", "line", "--speed", "120", "--frames", "150"});
  const auto early = report()["memory_peak_bytes"];
  fly({"--path", "line", "--speed", "120", "--frames", "600"});
  const auto late = report()["memory_peak_bytes"];
  for (const char* kind : {"maps", "heights", "meshes", "buffers"})
    EXPECT_LE(late[kind].get<double>(), 1.25 * early[kind].get<double>()) << kind;
}

/// The largest change of blue from a pixel to the one below it, anywhere in the picture's middle half.
int largestStep(const TePicture& picture) {
  int largest = 0;
  for (int x = picture.width / 4; x < 3 * picture.width / 4; ++x)
    for (int y = 1; y < picture.height; ++y)
      largest = std::max(largest, std::abs(int(picture.pixel(x, y)[2]) - int(picture.pixel(x, y - 1)[2])));
  return largest;
}

TEST_F(TerraneFlightRuns, HazeHidesTheRim) {
  const Arguments flat = {"--generator", "function:z=0", "--radius", "4",     "--frames",
                          "2",           "--path",       "line",     "--hud", "off"};
  const int hazy = largestStep(fly(flat));
  EXPECT_EQ(report()["patches"]["drawn"], 81);
  Arguments withoutHaze = flat;
  withoutHaze.insert(withoutHaze.end(), {"--haze", "off"});
  const int clear = largestStep(fly(withoutHaze));
  std::printf("largest step at the rim: %d with haze, %d without\n", hazy, clear);
  EXPECT_LT(hazy, clear / 4);
}

TEST_F(TerraneFlightRuns, ElevationDataIsFlownOver) {
  const std::string file = data("geotiff/mt_rainier_90m.tif");
  if (file.empty())
    GTEST_SKIP() << "no test data";
  const TePicture picture = fly({"--dem", file, "--radius", "3", "--path", "line", "--frames", "20"});
  EXPECT_GT(teGroundShare(picture), 0.1);
  EXPECT_EQ(report()["generator"], file);
  EXPECT_EQ(report()["frames_without_ground"], 0);
}

} // namespace
