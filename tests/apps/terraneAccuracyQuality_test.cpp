// How terrane-accuracy shows that a frame-time goal is held.

#include "apps/TeAppRun.h"
#include "apps/terrane-accuracy/TeQualityPlant.h"

#include <cmath>
#include <fstream>

namespace {

class TerraneAccuracyQuality : public TeAppRun {
protected:
  TerraneAccuracyQuality() : TeAppRun("terrane-accuracy") {}

  static std::string contents(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

TEST(TeQualityTrace, TellsWhenTheGoalWasReachedAgainAndHowOftenTheErrorTurned) {
  TeQualityTrace trace;
  trace.goal = 0.01;
  trace.steps = {{0, 1, 1}, {1, 4, 2}};
  for (int i = 1; i <= 400; ++i) {
    TeQualityTrace::Frame frame;
    frame.time = 0.01 * i;
    frame.seconds = i > 100 && i <= 130 ? 0.02 : i == 250 ? 1.0 : 0.0105;
    frame.pixelError = i <= 100 ? 1 : i <= 250 ? 2 : i <= 300 ? 3 : 2.5;
    trace.frames.push_back(frame);
  }
  ASSERT_TRUE(trace.returned(trace.steps[0]));
  EXPECT_NEAR(*trace.returned(trace.steps[0]), 0.05, 1e-9);
  ASSERT_TRUE(trace.returned(trace.steps[1]));
  EXPECT_NEAR(*trace.returned(trace.steps[1]), 0.33, 1e-9) << "the third of five good frames";
  EXPECT_FALSE(trace.returned(trace.steps[1], 0.01));
  EXPECT_EQ(trace.turns(trace.steps[1]), 1);
  EXPECT_NEAR(trace.settledCost(trace.steps[1]), 1.05, 1e-9);
}

TEST(TeQualityPlant, ReturnsToTheGoalWithinASecondAndRests) {
  for (const double exponent : {0.5, 1.0, 2.0}) {
    TeQualityPlant plant;
    plant.exponent = exponent;
    const std::vector<TeQualityTrace::Step> steps = {{0, 3, 1}, {3, 6, 2}, {6, 9, 0.5}, {9, 12, 2}};
    const TeQualityTrace trace = plant.run(steps);
    for (const TeQualityTrace::Step& step : steps) {
      ASSERT_TRUE(trace.returned(step));
      EXPECT_LE(*trace.returned(step), 1) << exponent << ", load " << step.load;
      EXPECT_NEAR(trace.settledCost(step), 1, 0.1) << exponent << ", load " << step.load;
      EXPECT_LE(trace.turns(step), 1) << exponent << ", load " << step.load;
    }
  }
}

TEST_F(TerraneAccuracyQuality, WritesTheSimulation) {
  const std::string folder = scratch("out/quality");
  const TeChildResult result = run({"quality", "--no-draw", "--out", folder, "--quiet"});
  ASSERT_EQ(result.status, 0) << result.error;
  const std::string csv = contents(folder + "/quality.csv");
  EXPECT_EQ(csv.rfind("run,time_s,load,frame_ms,goal_ms,wanted_px,bound_px,triangles\n", 0), 0u);
  const nlohmann::json json = nlohmann::json::parse(contents(folder + "/quality.json"));
  ASSERT_EQ(json["steps"].size(), 15u);
  for (const nlohmann::json& step : json["steps"])
    EXPECT_LE(step["seconds to within 10 %"].get<double>(), 1) << step;
  run({"quality", "--no-draw", "--out", folder, "--quiet"});
  EXPECT_EQ(contents(folder + "/quality.csv"), csv) << "a simulation repeats";
}

// The machine may be too busy for any statement about times: only that a flight is drawn and recorded.
TEST_F(TerraneAccuracyQuality, DrawsAFlight) {
  const std::string folder = scratch("out/flown");
  const TeChildResult result = run({"quality", "--out", folder, "--quiet", "--size", "160x120", "--radius",
                                    "4", "--seconds", "2", "--fps", "200"});
  ASSERT_EQ(result.status, 0) << result.error;
  const nlohmann::json json = nlohmann::json::parse(contents(folder + "/quality.json"));
  EXPECT_EQ(json["frames_a_second"], 200);
  int drawn = 0;
  for (const nlohmann::json& row : json["rows"])
    if (row["run"] == "drawn") {
      ++drawn;
      EXPECT_GT(row["triangles"], 0);
      EXPECT_LE(row["bound_px"].get<double>(), row["wanted_px"].get<double>() * (1 + 1e-9));
    }
  EXPECT_GT(drawn, 10);
}

TEST_F(TerraneAccuracyQuality, RefusesWhatMakesNoSense) {
  expectRefused({"quality", "--load", "1"}, 2, "--load");
  expectRefused({"quality", "--seconds", "0"}, 2, "--seconds");
  expectRefused({"quality", "--fps", "0"}, 2, "--fps");
}

} // namespace
