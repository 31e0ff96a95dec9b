// What terrane-static answers to bad usage, bad input and files that cannot be written: one line and a
// status.

#include "apps/TeAppRun.h"

#include <fstream>

namespace {

class TerraneStaticUsage : public TeAppRun {
protected:
  TerraneStaticUsage() : TeAppRun("terrane-static") {}
};

TEST_F(TerraneStaticUsage, HelpAndVersionSucceed) {
  const TeChildResult help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option :
       {"--context",   "--offscreen", "--size",    "--frames", "--dt",      "--seed",
        "--report",    "--quiet",     "--version", "--block",  "--samples", "--spacing",
        "--center",    "--generator", "--filter",  "--dem",    "--native",  "--vertical-scale",
        "--wireframe", "--parts",     "--export",  "--top",    "--water",   "--drape"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  EXPECT_TRUE(help.error.empty());
  const TeChildResult version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output.rfind("terrane-static 0.", 0), 0u) << version.output;
}

TEST_F(TerraneStaticUsage, GeneratorsAreListedWithTheirParameters) {
  const TeChildResult result = run({"--list-generators"});
  EXPECT_EQ(result.status, 0);
  for (const char* name :
       {"faults", "noise", "midpoint", "circles", "function", "elevation", "band", "matrix"})
    EXPECT_NE(result.output.find(std::string("  ") + name + "  "), std::string::npos) << name;
}

TEST_F(TerraneStaticUsage, UnknownOptions) {
  expectRefused({"--no-such-option"}, 2, "--no-such-option");
  expectRefused({"-z"}, 2, "-z");
  expectRefused({"stray"}, 2, "stray");
  expectRefused({"--block"}, 2, "--block");
  expectRefused({"--block", "3", "--block", "5"}, 2, "--block");
}

TEST_F(TerraneStaticUsage, NumbersOutOfRange) {
  const struct {
    const char* option;
    std::vector<const char*> values;
  } cases[] = {
      {"--block", {"0", "-1", "1000", "2.5", "nan", "x", "", "0x3", "99999999999999999999"}},
      {"--samples", {"0", "-1", "64", "3", "1000001", "nan", "6.5", "x"}},
      {"--spacing", {"0", "-1", "nan", "inf", "1e300", "x", ""}},
      {"--center", {"0", "1,", "nan,0", "0,inf", "1,2,3", "x,y", "1;2"}},
      {"--vertical-scale", {"0", "-1", "nan", "inf"}},
      {"--water", {"nan", "inf", "x"}},
      {"--size",
       {"0x10", "10x0", "-1x10", "10", "10x", "x10", "10x10x10", "100000x10", "nanx1",
        "4294967360x4294967344"}},
      {"--frames", {"0", "-1", "nan", "x"}},
      {"--dt", {"-1", "nan", "inf", "x"}},
      {"--seed", {"-1", "1.5", "nan", "x", "18446744073709551616"}},
      {"--context", {"glx", "", "WINDOW"}},
  };
  for (const auto& [option, values] : cases)
    for (const char* value : values)
      expectRefused({option, value, "--context", "osmesa"}, 2, option);
}

TEST_F(TerraneStaticUsage, GeneratorsAndFilters) {
  expectRefused({"--generator", "no-such"}, 2, "no-such");
  expectRefused({"--generator", "faults:no-such=1"}, 2, "no-such");
  expectRefused({"--generator", "faults:faults=0"}, 2, "faults");
  expectRefused({"--generator", "faults:faults=nan"}, 2, "faults");
  expectRefused({"--generator", "noise:wavelength=nan"}, 2, "wavelength");
  expectRefused({"--generator", ""}, 2, "generator");
  expectRefused({"--blend", "no-such"}, 2, "--blend");
  expectRefused({"--filter", "no-such"}, 2, "no-such");
  expectRefused({"--filter", "band:k=2"}, 2, "k");
  expectRefused({"--generator", "midpoint", "--samples", "67"}, 2, "67");
}

TEST_F(TerraneStaticUsage, ElevationFiles) {
  expectRefused({"--dem", "/no/such/file.tif"}, 2, "/no/such/file.tif");
  expectRefused({"--dem", "/tmp"}, 2, "/tmp");
  expectRefused({"--dem", ""}, 2, "--dem");
  expectRefused({"--dem", "x.tif", "--generator", "faults"}, 2, "--dem");
  expectRefused({"--native"}, 2, "--native");
  expectRefused({"--fill", "voids"}, 2, "--fill");
  const std::string empty = scratch("empty.tif"), text = scratch("text.tif");
  std::ofstream(empty).flush();
  std::ofstream(text) << "no elevation data";
  expectRefused({"--dem", empty}, 2, empty);
  expectRefused({"--dem", text}, 2, text);
  expectRefused({"--dem", text, "--vertical-unit", "furlong"}, 2, "furlong");
  expectRefused({"--dem", text, "--vertical-unit", "nan"}, 2, "nan");
  expectRefused({"--dem", text, "--fill", "all"}, 2, "--fill");
}

TEST_F(TerraneStaticUsage, TooMuchTerrain) {
  expectRefused({"--block", "255", "--samples", "8193"}, 2, "block");
  expectRefused({"--center", "1e300,0"}, 2, "");
}

TEST_F(TerraneStaticUsage, PicturesToDrape) {
  expectRefused({"--drape", "/no/such.png"}, 2, "/no/such.png");
  const std::string text = scratch("text.png");
  std::ofstream(text) << "no picture";
  expectRefused({"--drape", text}, 2, text);
}

TEST_F(TerraneStaticUsage, FilesThatCannotBeWritten) {
  for (const char* option : {"--offscreen", "--report", "--export"}) {
    expectRefused({"--context", "osmesa", "--size", "64x48", "--quiet", option, "/no/such/folder/out"}, 1,
                  "/no/such/folder/out");
    expectRefused({"--context", "osmesa", "--size", "64x48", "--quiet", option, "/dev/full"}, 1, "/dev/full");
    expectRefused({"--context", "osmesa", "--size", "64x48", "--quiet", option, scratch("")}, 1, scratch(""));
  }
}

TEST_F(TerraneStaticUsage, AWindowWithoutADisplayFails) {
  const TeChildResult result = run({"--context", "window"}, 20);
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_NE(result.error.find("display"), std::string::npos) << result.error;
}

TEST_F(TerraneStaticUsage, QuietSaysNothing) {
  const TeChildResult result = run({"--quiet", "--size", "64x48", "--offscreen", scratch("a.png")});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output + result.error, "");
}

TEST_F(TerraneStaticUsage, ProgressOfLongWorkIsLinesWithoutATerminal) {
  const TeChildResult result =
      run({"--generator", "circles:circles=60000", "--block", "4", "--size", "64x48", "--context", "osmesa"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.error.find("%\n"), std::string::npos) << result.error;
  EXPECT_EQ(result.error.find('\r'), std::string::npos);
}

} // namespace
