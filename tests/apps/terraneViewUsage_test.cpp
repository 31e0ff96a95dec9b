// What terrane-view answers to bad usage, bad input and files that cannot be written: one line and a status.

#include "apps/TeAppRun.h"
#include "apps/TeViewInputs.h"

#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace {

class TerraneViewUsage : public TeAppRun {
protected:
  TerraneViewUsage() : TeAppRun("terrane-view") {}

  std::string sceneOf(const std::string& text) const {
    const std::string path = scratch("scene.iv");
    std::ofstream(path) << "#Inventor V2.1 ascii\n" << text;
    return path;
  }
  std::string hills(int samples = 65) const {
    const std::string path = scratch("hills.asc");
    TeViewInputs::writeGrid(path, samples, 1000.0 / (samples - 1), TeViewInputs::hills);
    return path;
  }
  std::string pyramid(int top = 7) const {
    TeViewInputs::writePyramid(scratch("hills"), top, 0.01, TeViewInputs::hills);
    return scratch("hills");
  }
};

TEST_F(TerraneViewUsage, HelpAndVersionSucceed) {
  const TeChildResult help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option : {"--dem", "--clipmaps", "--size-m", "--height-scale", "--clip-size",
                             "--precision", "--geomorph", "--classic", "--coloring", "--texture",
                             "--wireframe", "--second-camera", "--path", "--statistics", "--pixel-error"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  EXPECT_EQ(run({"--version"}).output.rfind("terrane-view 0.", 0), 0u);
}

TEST_F(TerraneViewUsage, ExactlyOneInput) {
  expectRefused({}, 2, "nothing to show");
  expectRefused({"a.iv", "--dem", "b.tif"}, 2, "exclude");
  expectRefused({"--clipmaps", "a", "--dem", "b.tif"}, 2, "exclude");
  expectRefused({"a.iv", "b.iv"}, 2, "b.iv");
  expectRefused({"--no-such-option"}, 2, "--no-such-option");
}

TEST_F(TerraneViewUsage, NumbersOutOfRange) {
  const struct {
    const char* option;
    std::vector<const char*> values;
  } cases[] = {
      {"--precision", {"0", "0.5", "-1", "nan", "inf", "x", ""}},
      {"--pixel-error", {"0", "-1", "nan", "inf", "x"}},
      {"--fps", {"0", "-1", "nan", "1e9", "x"}},
      {"--size-m", {"0", "-1", "nan", "1e300"}},
      {"--height-scale", {"0", "-1", "nan", "inf"}},
      {"--clip-size", {"0", "4", "-1", "1e9", "2.5"}},
      {"--patch-resolution", {"0", "1", "1024", "x"}},
      {"--levels", {"0", "1", "10", "2.5"}},
      {"--resolution", {"0", "-16", "100000"}},
      {"--coloring", {"", "red"}},
      {"--speed", {"0", "-1", "nan"}},
      {"--altitude", {"-1", "nan"}},
      {"--eye", {"1,2", "x", "1,2,nan", "1,2,3,4"}},
      {"--up", {"x", ""}},
  };
  const std::string dem = hills();
  for (const auto& [option, values] : cases)
    for (const char* value : values)
      expectRefused({"--dem", dem, option, value, "--context", "osmesa"}, 2, option);
  expectRefused({"--dem", dem, "--resolution", "100"}, 2, "power of two");
  expectRefused({"--dem", dem, "--patch-resolution", "12"}, 2, "power of two");
  expectRefused({"--dem", dem, "--precision", "2", "--pixel-error", "2"}, 2, "--p");
  expectRefused({"--dem", dem, "--precision", "2", "--fps", "30"}, 2, "--p");
}

TEST_F(TerraneViewUsage, ColouringsNeedTheirPictures) {
  const std::string dem = hills();
  expectRefused({"--dem", dem, "--coloring", "texture"}, 2, "--texture");
  expectRefused({"--dem", dem, "--coloring", "detail"}, 2, "--detail");
  expectRefused({"--dem", dem, "--detail", "a.png"}, 2, "--mask");
  expectRefused({"--dem", dem, "--texture", "/no/such.png", "--context", "osmesa"}, 2, "/no/such.png");
}

TEST_F(TerraneViewUsage, Scenes) {
  expectRefused({"/no/such.iv", "--context", "osmesa"}, 2, "/no/such.iv");
  expectRefused({scratch(""), "--context", "osmesa"}, 2, "folder");
  const std::string text = scratch("text.iv");
  std::ofstream(text) << "no scene";
  expectRefused({text, "--context", "osmesa"}, 2, text);
  expectRefused({sceneOf("Separator { Cube { width x } }"), "--context", "osmesa"}, 2, "width");
  expectRefused({sceneOf("Cube {}"), "--size-m", "3"}, 2, "--size-m");
}

TEST_F(TerraneViewUsage, ElevationFiles) {
  expectRefused({"--dem", "/no/such.tif", "--context", "osmesa"}, 2, "/no/such.tif");
  const std::string text = scratch("text.tif");
  std::ofstream(text) << "no elevation data";
  expectRefused({"--dem", text, "--context", "osmesa"}, 2, text);
  expectRefused({"--dem", hills(), "--vertical-unit", "furlong"}, 2, "furlong");
  expectRefused({"--fill", "voids"}, 2, "--fill");
  const std::string holes = scratch("holes.asc");
  TeViewInputs::writeGrid(holes, 33, 10, [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.5) < 0.1 ? std::nan("") : 100 * x;
  });
  expectRefused({"--dem", holes, "--context", "osmesa"}, 2, "--fill voids");
}

TEST_F(TerraneViewUsage, Pyramids) {
  expectRefused({"--clipmaps", scratch("none"), "--context", "osmesa"}, 2, scratch("none"));
  const std::string name = pyramid(4);
  std::ofstream(name + ".json") << "{ \"spacing_m\": \"far\" }";
  expectRefused({"--clipmaps", name, "--context", "osmesa"}, 2, name + ".json");
  std::ofstream(name + ".json") << "[";
  expectRefused({"--clipmaps", name, "--context", "osmesa"}, 2, name + ".json");
  std::filesystem::remove(name + ".json");
  ASSERT_EQ(::mkfifo((name + ".json").c_str(), 0600), 0); // nobody will ever write to it
  expectRefused({"--clipmaps", name, "--context", "osmesa"}, 2, name + ".json");
}

TEST_F(TerraneViewUsage, Paths) {
  expectRefused({"--dem", hills(), "--path", "spiral", "--context", "osmesa"}, 2, "circle");
  const std::string path = scratch("path.txt");
  std::ofstream(path) << "0 0 ten\n";
  expectRefused({"--dem", hills(), "--path", path, "--context", "osmesa"}, 2, "path.txt:1");
}

TEST_F(TerraneViewUsage, FilesThatCannotBeWritten) {
  const std::string scene = sceneOf("Cube {}");
  for (const char* option : {"--offscreen", "--report"})
    for (const char* place : {"/no/such/folder/out", "/dev/full"})
      expectRefused({scene, "--context", "osmesa", "--size", "64x48", "--quiet", option, place}, 1, place);
}

TEST_F(TerraneViewUsage, AWindowWithoutADisplayFails) {
  const TeChildResult result = run({sceneOf("Cube {}"), "--context", "window"}, 20);
  EXPECT_EQ(result.status, 1) << result.error;
  EXPECT_NE(result.error.find("display"), std::string::npos) << result.error;
}

TEST_F(TerraneViewUsage, QuietSaysNothing) {
  const TeChildResult result =
      run({"--dem", hills(), "--quiet", "--size", "64x48", "--offscreen", scratch("a.png")});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output + result.error, "");
}

} // namespace
