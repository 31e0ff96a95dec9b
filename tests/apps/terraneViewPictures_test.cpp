// What terrane-view shows, and what it says about it.

#include "apps/TeAppRun.h"
#include "apps/TeViewInputs.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace {

using Arguments = std::vector<std::string>;

class TerraneViewPictures : public TeAppRun {
protected:
  TerraneViewPictures() : TeAppRun("terrane-view") {}

  std::string sceneOf(const std::string& text) const {
    const std::string path = scratch("scene.iv");
    std::ofstream(path) << "#Inventor V2.1 ascii\n" << text;
    return path;
  }
  /// Hills of 1 km.
  Arguments hills(Arguments more = {}, int samples = 257) const {
    const std::string path = scratch("hills.asc");
    TeViewInputs::writeGrid(path, samples, 1000.0 / (samples - 1), TeViewInputs::hills);
    more.insert(more.begin(), {"--dem", path, "--eye", "0,-480,160", "--look", "0,0,60"});
    return more;
  }
  /// The same as a pyramid.
  Arguments pyramid(Arguments more = {}) const {
    const std::string name = scratch("hills");
    TeViewInputs::writePyramid(name, 8, 0.01, TeViewInputs::hills);
    std::ofstream(name + ".json") << R"({"spacing_m": 3.90625, "height_unit_m": 0.01, "height_offset_m": 0})";
    more.insert(more.begin(), {"--clipmaps", name, "--eye", "0,-480,160", "--look", "0,0,60"});
    return more;
  }
  double figure(const char* name, const char* kind = "median") const {
    return report()[name][kind].get<double>();
  }
};

int countIf(const TePicture& picture, const std::function<bool(const TePicture::Pixel&)>& counts) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      count += counts(picture.pixel(x, y));
  return count;
}

bool isRed(const TePicture::Pixel& p) { return p[0] > 90 && p[0] > 2 * p[1] && p[0] > 2 * p[2]; }

TEST_F(TerraneViewPictures, AnySceneIsShownWhole) {
  const TePicture picture =
      draw({sceneOf("BaseColor { rgb 1 0 0 } LightModel { model BASE_COLOR } Cube { width 9 }")});
  EXPECT_GT(countIf(picture, isRed), 320 * 240 / 20);
  for (int x = 0; x < picture.width; ++x)
    EXPECT_FALSE(isRed(picture.pixel(x, 0)) || isRed(picture.pixel(x, picture.height - 1)));
  EXPECT_EQ(report()["box_m"][1][0], 4.5);
  EXPECT_GT(report()["frame_ms"]["median"], 0);
  EXPECT_FALSE(report().contains("triangles")) << "no terrain is in it";
}

TEST_F(TerraneViewPictures, TheScenesOwnCameraIsTheStart) {
  // Looks along -z at a red cube in the middle; y is up, and a green one lies above it.
  const std::string scene = sceneOf("PerspectiveCamera { position 0 0 10 } LightModel { model BASE_COLOR } "
                                    "BaseColor { rgb 1 0 0 } Cube { } "
                                    "Translation { translation 0 3 0 } BaseColor { rgb 0 1 0 } Cube { }");
  const TePicture picture = draw({scene});
  EXPECT_TRUE(isRed(picture.pixel(160, 120)));
  EXPECT_EQ(picture.pixel(160, 205)[1], 255) << "above";
  EXPECT_NEAR(report()["eye_m"][1].get<double>(), -10, 1e-5) << "with z up";
  // With z up as it stands, one looks down.
  draw({scene, "--up", "z"});
  EXPECT_EQ(report()["eye_m"], nlohmann::json({0, 0, 10}));
  EXPECT_EQ(report()["direction"], nlohmann::json({0, 0, -1}));
}

TEST_F(TerraneViewPictures, OurNodesInFiles) {
  const TePicture picture = draw({sceneOf("TeStaticTerrain { seed 7 }")});
  EXPECT_GT(teGroundShare(picture), 0.1);
  draw({sceneOf("TeSeamlessPatches { }")});
  EXPECT_GT(figure("triangles"), 100);
  EXPECT_EQ(report()["settings"]["precision"], 2);
  draw({sceneOf("TeSeamlessPatches { precision 3 }")});
  EXPECT_EQ(report()["settings"]["precision"], 3);
  draw({sceneOf("TeSeamlessPatches { precision 3 }"), "--precision", "1.5", "--classic"});
  EXPECT_EQ(report()["settings"]["precision"], 1.5);
  EXPECT_EQ(report()["settings"]["instancing"], false);
}

TEST_F(TerraneViewPictures, AnElevationFileAsItIs) {
  const TePicture picture = draw(hills());
  EXPECT_GT(teGroundShare(picture), 0.3);
  EXPECT_LT(teGroundShare(picture), 0.9);
  const nlohmann::json& box = report()["box_m"];
  EXPECT_NEAR(box[0][0].get<double>(), -500, 0.01);
  EXPECT_NEAR(box[1][1].get<double>(), 500, 0.01);
  double low = 1e9, high = -1e9;
  for (int y = 0; y <= 256; ++y)
    for (int x = 0; x <= 256; ++x) {
      const double h = TeViewInputs::hills(x / 256.0, y / 256.0);
      low = std::min(low, h);
      high = std::max(high, h);
    }
  EXPECT_NEAR(box[0][2].get<double>(), low, 0.01);
  EXPECT_NEAR(box[1][2].get<double>(), high, 0.01);
}

TEST_F(TerraneViewPictures, OtherSizesAreResampled) {
  const TePicture exact = draw(hills({"--pixel-error", "0.3"}));
  const TePicture resampled = draw(hills({"--pixel-error", "0.3"}, 201));
  EXPECT_NEAR(report()["box_m"][1][0].get<double>(), 500, 0.01);
  EXPECT_LT(teDifferingShare(exact, resampled, 24), 0.02);
  draw(hills({"--resolution", "32"}));
  EXPECT_LE(figure("triangles"), 2 * 32 * 32);
}

TEST_F(TerraneViewPictures, VoidsAreFilled) {
  const std::string path = scratch("holes.asc");
  TeViewInputs::writeGrid(path, 65, 10, [](double x, double y) {
    return std::hypot(x - 0.5, y - 0.5) < 0.05 ? std::nan("") : 100.0;
  });
  draw({"--dem", path, "--fill", "voids"});
  EXPECT_NEAR(report()["box_m"][0][2].get<double>(), 100, 1e-3);
  EXPECT_NEAR(report()["box_m"][1][2].get<double>(), 100, 1e-3);
}

TEST_F(TerraneViewPictures, SizeAndHeightCanBeStretched) {
  draw(hills({"--size-m", "4000", "--height-scale", "2"}));
  EXPECT_NEAR(report()["box_m"][1][0].get<double>(), 2000, 0.01);
  const double high = report()["box_m"][1][2];
  draw(hills());
  EXPECT_NEAR(report()["box_m"][1][2].get<double>() * 2, high, 0.01);
}

TEST_F(TerraneViewPictures, PathsKeepAboveStretchedHeights) {
  draw(hills({"--height-scale", "3", "--path", "circle", "--frames", "2", "--dt", "0.1"}));
  const nlohmann::json& eye = report()["eye_m"];
  const double ground =
      TeViewInputs::hills(0.5 + eye[0].get<double>() / 1000, 0.5 + eye[1].get<double>() / 1000);
  EXPECT_GT(ground, 10);
  EXPECT_GT(eye[2].get<double>(), 3 * ground + 9);
}

TEST_F(TerraneViewPictures, APyramidLooksLikeTheFileItWasMadeFrom) {
  const TePicture white{2, 2, std::vector<std::uint8_t>(16, 255)};
  ASSERT_TRUE(white.writePng(scratch("white.png")));
  const Arguments light = {"--texture", scratch("white.png"), "--precision", "8"};
  const TePicture file = draw(hills(light));
  Arguments windows = light;
  windows.insert(windows.end(), {"--clip-size", "257"});
  const TePicture clipmaps = draw(pyramid(windows));
  EXPECT_LT(teDifferingShare(file, clipmaps, 8), 0.01);
  EXPECT_GT(teGroundShare(file), 0.3);
}

TEST_F(TerraneViewPictures, SmallClipWindowsFillWhileOneFlies) {
  draw(pyramid({"--clip-size", "65", "--frames", "30", "--dt", "0.1", "--path", "circle"}));
  EXPECT_GT(report()["bytes_uploaded_in_all"], 65 * 65 * 2);
  EXPECT_GT(figure("triangles"), 1000);
}

TEST_F(TerraneViewPictures, InstancedAndClassicDrawTheSame) {
  const TePicture instanced = draw(hills({"--coloring", "plain"}));
  const double calls = figure("draw_calls"), triangles = figure("triangles");
  const TePicture classic = draw(hills({"--coloring", "plain", "--classic"}));
  EXPECT_EQ(instanced, classic);
  EXPECT_EQ(figure("triangles"), triangles);
  EXPECT_EQ(figure("draw_calls"), 8 * figure("patches_rendered"));
  EXPECT_LT(calls, figure("draw_calls"));
}

TEST_F(TerraneViewPictures, PlainShowsTilesAndStrips) {
  const TePicture picture = draw(hills({"--coloring", "plain"}));
  const int strips = countIf(picture, isRed);
  const int tiles = countIf(picture, [](const TePicture::Pixel& p) {
    return std::abs(p[0] - p[1]) < 30 && std::abs(p[1] - p[2]) < 30;
  });
  EXPECT_GT(strips, 500);
  EXPECT_GT(tiles, strips);
}

TEST_F(TerraneViewPictures, MorePrecisionMeansMoreTriangles) {
  draw(hills({"--precision", "1"}));
  const double few = figure("triangles");
  draw(hills({"--precision", "4"}));
  EXPECT_GT(figure("triangles"), 1.5 * few);
}

TEST_F(TerraneViewPictures, AWantedPixelErrorIsKept) {
  for (const double wanted : {1.0, 8.0}) {
    draw(hills({"--pixel-error", std::to_string(wanted)}));
    EXPECT_LE(figure("error_bound_px", "worst"), wanted);
  }
  draw(hills({"--pixel-error", "1"}));
  const double fine = figure("triangles");
  draw(hills({"--pixel-error", "8"}));
  EXPECT_GT(fine, figure("triangles"));
}

TEST_F(TerraneViewPictures, WireframeShowsWhatIsBehind) {
  const TePicture solid = draw(hills());
  const TePicture lines = draw(hills({"--wireframe"}));
  EXPECT_LT(teGroundShare(lines), teGroundShare(solid));
  EXPECT_GT(teGroundShare(lines), 0.02);
  // Other shapes, too.
  const std::string scene = sceneOf("Sphere { }");
  EXPECT_LT(teGroundShare(draw({scene, "--wireframe"})), teGroundShare(draw({scene})));
}

TEST_F(TerraneViewPictures, TheSecondCameraShowsWhatTheFirstOneDraws) {
  const TePicture first = draw(hills());
  const double triangles = figure("triangles"), culled = figure("patches_culled");
  const TePicture second = draw(hills({"--second-camera"}));
  EXPECT_EQ(figure("triangles"), triangles);
  EXPECT_EQ(figure("patches_culled"), culled);
  EXPECT_GT(teDifferingShare(first, second), 0.3);
  const int orange = countIf(
      second, [](const TePicture::Pixel& p) { return p[0] > 230 && p[1] > 90 && p[1] < 140 && p[2] < 40; });
  EXPECT_GT(orange, 100) << "the lines of the first camera's view";
}

TEST_F(TerraneViewPictures, StatisticsAreWrittenOverThePicture) {
  for (const Arguments& method : {Arguments(), Arguments{"--method", "roam"}}) {
    Arguments arguments = {"--size", "640x480"};
    arguments.insert(arguments.end(), method.begin(), method.end());
    const TePicture plain = draw(hills(arguments));
    arguments.push_back("--statistics");
    const TePicture text = draw(hills(arguments));
    const auto differsIn = [&](int x0, int y0, int x1, int y1) {
      int differing = 0;
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
          differing += plain.pixel(x, y) != text.pixel(x, y);
      return double(differing) / ((x1 - x0) * (y1 - y0));
    };
    EXPECT_GT(differsIn(20, 360, 300, 460), 0.9) << "its panel";
    EXPECT_EQ(differsIn(0, 0, 640, 240), 0);
  }
}

TEST_F(TerraneViewPictures, AnyMethodIsReportedAndHoldsItsError) {
  draw(hills({"--method", "roam", "--pixel-error", "3"}));
  EXPECT_GT(figure("triangles"), 100);
  EXPECT_GT(figure("draw_calls"), 0);
  EXPECT_GT(figure("error_bound_px"), 0);
  EXPECT_LE(figure("error_bound_px"), 3);
}

TEST_F(TerraneViewPictures, AnyMethodIsSteeredByAFrameRate) {
  // No frame is drawn in a thousandth of a second, so the error has to grow.
  for (const Arguments& method : {Arguments(), Arguments{"--method", "quadtree"}}) {
    Arguments arguments = {"--fps", "1000", "--frames", "60"};
    arguments.insert(arguments.end(), method.begin(), method.end());
    draw(hills(arguments));
    EXPECT_GT(report()["settings"]["pixel_error"], 1);
  }
}

TEST_F(TerraneViewPictures, ATextureLiesNorthUp) {
  TePicture image;
  image.width = image.height = 64;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int channel : {y >= 32 ? 255 : 0, 0, y >= 32 ? 0 : 255, 255})
        image.rgba.push_back(std::uint8_t(channel));
  ASSERT_TRUE(image.writePng(scratch("texture.png")));
  Arguments above = hills({"--texture", scratch("texture.png")});
  *std::find(above.begin(), above.end(), "0,-480,160") = "0,-1,2000";
  const TePicture picture = draw(above);
  EXPECT_TRUE(isRed(picture.pixel(160, 140))) << "its upper half in the north";
  const TePicture::Pixel south = picture.pixel(160, 100);
  EXPECT_GT(south[2], 2 * south[0]);
}

TEST_F(TerraneViewPictures, RunsWithAStepRepeat) {
  const Arguments flight =
      hills({"--path", "circle", "--frames", "25", "--dt", "0.1", "--geomorph", "--statistics"});
  const TePicture a = draw(flight);
  const nlohmann::json eye = report()["eye_m"];
  EXPECT_EQ(draw(flight), a);
  EXPECT_EQ(report()["eye_m"], eye);
  EXPECT_EQ(report()["frames"], 25);
  EXPECT_NEAR(report()["path"]["metres"].get<double>(), 25 * 0.1 * 1000 / 60, 0.5);
  // The circle around the middle, some metres above the ground.
  EXPECT_NEAR(std::hypot(eye[0].get<double>(), eye[1].get<double>()), 300, 3);
  const double ground =
      TeViewInputs::hills(0.5 + eye[0].get<double>() / 1000, 0.5 + eye[1].get<double>() / 1000);
  EXPECT_GT(eye[2].get<double>(), ground + 9);
  EXPECT_LT(eye[2].get<double>(), ground + 60);
}

TEST_F(TerraneViewPictures, WaypointsFromAFile) {
  std::ofstream(scratch("path.txt")) << "0 -400 200 100\n0 400 200\n";
  draw(hills({"--path", scratch("path.txt"), "--frames", "20", "--dt", "0.1"}));
  EXPECT_NEAR(report()["eye_m"][1].get<double>(), -200, 1e-6);
  EXPECT_EQ(report()["eye_m"][2], 200);
}

TEST_F(TerraneViewPictures, OsMesaAndEglDrawTheSame) {
  const TePicture a = draw(hills(), "osmesa");
  const TePicture b = draw(hills(), "egl");
  if (report()["renderer"].get<std::string>().find("llvmpipe") == std::string::npos)
    EXPECT_LT(teDifferingShare(a, b, 24), 0.02) << "a GPU rounds differently";
  else
    EXPECT_EQ(a, b);
}

} // namespace
