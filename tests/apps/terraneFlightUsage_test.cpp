// What terrane-flight answers to bad usage, bad input and files that cannot be written.

#include "apps/TeAppRun.h"

#include <fstream>

namespace {

class TerraneFlightUsage : public TeAppRun {
protected:
  TerraneFlightUsage() : TeAppRun("terrane-flight") {}

  /// A short run that would succeed, with these arguments added.
  static std::vector<std::string> with(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--context", "osmesa", "--size", "64x48", "--quiet"});
    return arguments;
  }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(scratch(name)) << text;
    return scratch(name);
  }
};

TEST_F(TerraneFlightUsage, HelpNamesEveryOption) {
  const TeChildResult help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option :
       {"--context",   "--offscreen",   "--size",    "--frames",  "--dt",       "--seed",
        "--report",    "--quiet",       "--version", "--samples", "--spacing",  "--center",
        "--generator", "--filter",      "--dem",     "--radius",  "--budget",   "--units",
        "--fps",       "--workers",     "--record",  "--replay",  "--haze",     "--hud",
        "--view",      "--screenshots", "--path",    "--speed",   "--altitude", "--pixel-error"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  EXPECT_TRUE(help.error.empty());
  EXPECT_EQ(run({"--version"}).output.rfind("terrane-flight 0.", 0), 0u);
  EXPECT_NE(run({"--list-generators"}).output.find("  noise  "), std::string::npos);
}

TEST_F(TerraneFlightUsage, NumbersOutOfRange) {
  const struct {
    const char* option;
    std::vector<const char*> values;
  } cases[] = {
      {"--radius", {"0", "-1", "65", "1.5", "nan"}},
      {"--budget", {"0", "-1", "1e9", "nan", "inf", "x", ""}},
      {"--units", {"0", "-1", "1e3", "99999999999", "nan"}},
      {"--fps", {"0", "-1", "nan", "1e9"}},
      {"--pixel-error", {"0", "-1", "nan", "inf", "1e9", "x"}},
      {"--workers", {"-1", "65", "nan"}},
      {"--speed", {"-1", "nan", "inf", "1e9", "x"}},
      {"--altitude", {"-1", "nan", "inf"}},
      {"--haze", {"", "thick"}},
      {"--hud", {"yes"}},
      {"--view", {"second"}},
      {"--dt", {"-1", "nan", "inf"}},
  };
  for (const auto& [option, values] : cases)
    for (const char* value : values)
      expectRefused({option, value, "--context", "osmesa"}, 2, option);
}

TEST_F(TerraneFlightUsage, ContradictingOptions) {
  expectRefused(with({"--units", "5"}), 2, "--dt");
  expectRefused(with({"--units", "5", "--budget", "3", "--dt", "0.1"}), 2, "--budget");
  expectRefused(with({"--record", "a", "--replay", "b"}), 2, "--re");
  expectRefused(with({"--path", "line", "--speed", "0"}), 2, "--speed");
}

TEST_F(TerraneFlightUsage, PathsThatCannotBeFlown) {
  expectRefused(with({"--path", "cirkle"}), 2, "circle");
  expectRefused(with({"--path", "/no/such/path.txt"}), 2, "/no/such/path.txt");
  expectRefused(with({"--path", "/tmp"}), 2, "/tmp");
  expectRefused(with({"--path", file("p", "0 0 100\n0 nan 100\n")}), 2, "p:2: ");
  expectRefused(with({"--path", file("q", "")}), 2, "q: path of 0 points");
  expectRefused(with({"--path", file("far", "0 0 100\n0 3e15 100\n"), "--spacing", "0.5"}), 2, "point 2");
}

TEST_F(TerraneFlightUsage, WorldsThatCannotBe) {
  expectRefused(with({"--generator", "no-such"}), 2, "no-such");
  expectRefused(with({"--generator", "midpoint", "--samples", "67"}), 2, "67");
  expectRefused(with({"--center", "1e300,0"}), 2, "--center");
  expectRefused(with({"--dem", "/no/such.tif"}), 2, "/no/such.tif");
}

TEST_F(TerraneFlightUsage, FilesThatCannotBeWritten) {
  for (const char* option : {"--offscreen", "--report", "--record"}) {
    expectRefused(with({option, "/no/such/folder/out"}), 1, "/no/such/folder/out");
    expectRefused(with({option, "/dev/full"}), 1, "/dev/full");
  }
}

TEST_F(TerraneFlightUsage, RecordingsThatCannotBeReplayed) {
  expectRefused(with({"--replay", "/no/such/recording"}), 2, "/no/such/recording");
  expectRefused(with({"--replay", file("text", "a b c\n")}), 2, "text:1: ");
  const std::string recording = scratch("recording");
  ASSERT_EQ(run(with({"--record", recording, "--dt", "0.1", "--frames", "5"})).status, 0);
  ASSERT_EQ(run(with({"--replay", recording, "--dt", "0.1"})).status, 0);
  std::ifstream stream(recording, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  expectRefused(with({"--replay", file("cut", text.substr(0, text.size() - 30)), "--dt", "0.1"}), 2, "cut:");
  expectRefused(with({"--replay", recording, "--dt", "0.1", "--seed", "1"}), 2, "seed");
  expectRefused(with({"--replay", recording, "--dt", "0.2"}), 2, "dt");
  expectRefused(with({"--replay", recording, "--dt", "0.1", "--path", "line"}), 2, "path");
}

TEST_F(TerraneFlightUsage, QuietSaysNothing) {
  const TeChildResult quiet = run(with({"--frames", "2"}));
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.output + quiet.error, "");
  const TeChildResult result = run({"--frames", "2", "--context", "osmesa", "--size", "64x48"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output.rfind("2 ticks, ", 0), 0u) << result.output;
}

TEST_F(TerraneFlightUsage, AWindowWithoutADisplayFails) {
  expectRefused({"--context", "window", "--quiet"}, 1, "display");
}

} // namespace
