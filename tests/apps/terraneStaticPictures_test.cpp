// What terrane-static shows.

#include "apps/TeAppRun.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <fstream>

namespace {

using Arguments = std::vector<std::string>;

class TerraneStaticPictures : public TeAppRun {
protected:
  TerraneStaticPictures() : TeAppRun("terrane-static") {}
};

TEST_F(TerraneStaticPictures, OsMesaAndEglDrawTheSame) {
  const TePicture a = draw({"--seed", "7"}, "osmesa");
  const TePicture b = draw({"--seed", "7"}, "egl");
  EXPECT_GT(teGroundShare(a), 0.2);
  if (report()["renderer"].get<std::string>().find("llvmpipe") == std::string::npos)
    EXPECT_LT(teDifferingShare(a, b, 24), 0.01) << "a GPU rounds differently";
  else
    EXPECT_EQ(a, b);
}

TEST_F(TerraneStaticPictures, AWindowShowsTheSame) {
  if (teRunChild({"xvfb-run", "--help"}).status != 0)
    GTEST_SKIP() << "no xvfb-run";
  const TePicture a = draw({"--seed", "7", "--size", "640x480"}, "osmesa");
  const TePicture b = draw({"--seed", "7", "--size", "640x480"}, "window");
  // The window has no smoothed edges.
  EXPECT_LT(teDifferingShare(a, b, 24), 0.03);
}

TEST_F(TerraneStaticPictures, ASeedIsAWorld) {
  const TePicture a = draw({"--seed", "7"});
  EXPECT_EQ(draw({"--seed", "7", "--frames", "3"}), a);
  EXPECT_EQ(report()["frames"], 3);
  EXPECT_GT(teDifferingShare(draw({"--seed", "8"}), a), 0.2);
}

// They are no octal numbers.
TEST_F(TerraneStaticPictures, NumbersMayBeginWithZeros) {
  draw({"--seed", "0123", "--block", "01", "--samples", "017", "--size", "0064x048"});
  EXPECT_EQ(report()["seed"], 123);
  EXPECT_EQ(report()["patches"], 1);
  EXPECT_EQ(report()["samples"], 17);
  EXPECT_EQ(report()["picture_size"], nlohmann::json({64, 48}));
}

TEST_F(TerraneStaticPictures, TheReportSaysWhatWasDone) {
  draw({"--seed", "18446744073709551615", "--generator", "noise:type=ridged", "--filter", "matrix", "--block",
        "2", "--samples", "33", "--spacing", "4", "--center", "-100,200"});
  EXPECT_EQ(report()["seed"], 18446744073709551615u);
  EXPECT_EQ(report()["generator"], "noise:type=ridged | matrix");
  EXPECT_EQ(report()["patches"], 4);
  EXPECT_EQ(report()["samples"], 33);
  EXPECT_EQ(report()["side_m"], 128);
  // A block of 2 × 16 cells without the outermost strip.
  EXPECT_EQ(report()["triangles"], 30 * 30 * 2);
  EXPECT_EQ(report()["context"], "osmesa");
  EXPECT_EQ(report()["picture_size"], (std::vector<int>{320, 240}));
  EXPECT_LT(report()["height_minimum_m"], report()["height_maximum_m"]);
  for (const char* time : {"terrain", "model", "frame_mean", "frame_longest"})
    EXPECT_GT(report()["times_ms"][time], 0) << time;
  EXPECT_GT(report()["memory_peak_bytes"], 1 << 20);
  EXPECT_EQ(report()["picture_hash"].get<std::string>().size(), 16u);
}

TEST_F(TerraneStaticPictures, FarAwayLooksNoWorse) {
  // The same expression around both places: the pictures must agree although coordinates reach 1e12 m.
  const Arguments near = {"--generator", "function:z=9*sin(x/8)*cos(y/11)", "--center", "0,0"};
  const TePicture a = draw(near);
  const TePicture b =
      draw({"--generator", "function:z=9*sin((x-1099511627776)/8)*cos(y/11)", "--center", "1099511627776,0"});
  EXPECT_LT(teDifferingShare(a, b, 2), 0.002);
}

TEST_F(TerraneStaticPictures, LinearBlendingMakesOtherLand) {
  EXPECT_NE(draw({"--blend", "linear"}), draw({}));
  EXPECT_EQ(draw({"--blend", "smooth"}), draw({}));
}

TEST_F(TerraneStaticPictures, ViewOptionsChangeThePicture) {
  const TePicture plain = draw({"--seed", "3"});
  const int triangles = report()["triangles"];
  for (const Arguments& option : std::vector<Arguments>{
           {"--wireframe"}, {"--parts"}, {"--top"}, {"--water", "0"}, {"--vertical-scale", "2"}}) {
    Arguments arguments = {"--seed", "3"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    EXPECT_GT(teDifferingShare(draw(arguments), plain), 0.05) << option[0];
    EXPECT_EQ(report()["triangles"], triangles + (option[0] == "--water" ? 2 : 0)) << option[0];
  }
}

TEST_F(TerraneStaticPictures, FromTheTopTheBlockIsASquareWithNorthUp) {
  // Rising to the north-east, and with water over the low half: blue in the south-west alone.
  const TePicture picture =
      draw({"--generator", "function:z=(x+y)/100", "--top", "--water", "0", "--size", "300x300"});
  const auto blueness = [&](int x, int y) {
    return int(picture.pixel(x, y)[2]) - int(picture.pixel(x, y)[0]);
  };
  EXPECT_GT(blueness(60, 60), 20) << "south-west";
  EXPECT_LT(blueness(240, 240), 20) << "north-east";
  EXPECT_GT(teGroundShare(picture), 0.8);
}

TEST_F(TerraneStaticPictures, PartsHaveThreeColours) {
  const TePicture picture = draw({"--generator", "function:z=0", "--parts", "--top", "--size", "480x480"});
  int left = 0;
  while (left < 240 && picture.pixel(left, 240) == picture.pixel(0, 0))
    ++left;
  // 94 cells of the block are drawn, 30 of the first patch and then 2 of the seam.
  const int seam = left + int(31.0 / 94 * (480 - 2 * left));
  const TePicture::Pixel inside = picture.pixel(240, 240);
  EXPECT_EQ(picture.pixel(seam, 240), picture.pixel(240, seam));
  EXPECT_NE(picture.pixel(seam, 240), inside);
  EXPECT_NE(picture.pixel(seam, seam), inside);
  EXPECT_NE(picture.pixel(seam, seam), picture.pixel(seam, 240));
}

TEST_F(TerraneStaticPictures, ADrapedPictureLiesNorthUp) {
  TePicture image;
  image.width = image.height = 64;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool north = y >= 32, east = x >= 32;
      const TePicture::Pixel colour = {std::uint8_t(north ? 255 : 0), std::uint8_t(east ? 255 : 0), 0, 255};
      image.rgba.insert(image.rgba.end(), colour.begin(), colour.end());
    }
  ASSERT_TRUE(image.writePng(scratch("image.png")));
  const TePicture picture =
      draw({"--generator", "function:z=0", "--drape", scratch("image.png"), "--top", "--size", "200x200"});
  const auto is = [&](int x, int y, bool red, bool green) {
    const TePicture::Pixel pixel = picture.pixel(x, y);
    return (pixel[0] > 100) == red && (pixel[1] > 100) == green && pixel[2] < 60;
  };
  EXPECT_TRUE(is(50, 50, false, false)) << "south-west";
  EXPECT_TRUE(is(150, 50, false, true)) << "south-east";
  EXPECT_TRUE(is(50, 150, true, false)) << "north-west";
  EXPECT_TRUE(is(150, 150, true, true)) << "north-east";
}

TEST_F(TerraneStaticPictures, TheExportedFileIsTheSceneInCoreNodes) {
  draw({"--seed", "7", "--export", scratch("terrain.iv")});
  SoDB::init();
  SoInput input;
  ASSERT_TRUE(input.openFile(scratch("terrain.iv").c_str()));
  SoSeparator* scene = SoDB::readAll(&input);
  ASSERT_NE(scene, nullptr);
  scene->ref();
  SoGetPrimitiveCountAction count;
  count.apply(scene);
  EXPECT_EQ(count.getTriangleCount(), report()["triangles"].get<int>());
  std::ifstream stream(scratch("terrain.iv"));
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  EXPECT_EQ(text.find("Te"), text.find("Texture")) << "a class of Terrane's own";
  EXPECT_NE(text.find("PerspectiveCamera"), std::string::npos);
  scene->unref();
}

TEST_F(TerraneStaticPictures, MountRainier) {
  const std::string file = data("geotiff/mt_rainier_90m.tif");
  if (file.empty())
    GTEST_SKIP() << "no test data";
  const TePicture picture = draw({"--dem", file, "--fill", "voids"});
  EXPECT_GT(teGroundShare(picture), 0.3);
  EXPECT_NEAR(report()["height_maximum_m"], 4371, 15);
  EXPECT_NEAR(report()["height_minimum_m"], 263, 15);
  // One degree of latitude is 111 km long.
  EXPECT_NEAR(report()["side_m"], 111200, 1200);
}

TEST_F(TerraneStaticPictures, PugetSound) {
  const std::string file = data("png16/ps_height_1k.png");
  if (file.empty())
    GTEST_SKIP() << "no test data";
  const TePicture picture = draw({"--dem", file, "--posts", "160", "--vertical-unit", "0.1"});
  EXPECT_GT(teGroundShare(picture), 0.3);
  EXPECT_NEAR(report()["height_maximum_m"], 4379.8, 5);
  EXPECT_NEAR(report()["side_m"], 160 * 1025, 1500);
  EXPECT_GT(teGroundShare(draw({"--dem", file, "--posts", "160", "--vertical-unit", "dm", "--block", "4"})),
            0.3);
}

TEST_F(TerraneStaticPictures, NativePostsAreTheFilesOwn) {
  const std::string file = data("png16/ps_height_1k.png");
  if (file.empty())
    GTEST_SKIP() << "no test data";
  draw({"--dem", file, "--posts", "160", "--vertical-unit", "0.1", "--native", "--samples", "129"});
  EXPECT_EQ(report()["spacing_m"], 160);
  // The highest post, 43798 in units of 0.1 m, is in the block.
  EXPECT_FLOAT_EQ(report()["height_maximum_m"].get<float>(), 4379.8f);
  const std::string degrees = data("geotiff/mt_rainier_90m.tif");
  const TeChildResult refused = run({"--dem", degrees, "--native"});
  EXPECT_EQ(refused.status, 2) << refused.error;
}

TEST_F(TerraneStaticPictures, OutsideTheFile) {
  const std::string file = data("geotiff/bigtujunga.tif");
  if (file.empty())
    GTEST_SKIP() << "no test data";
  const double hole = teGroundShare(draw({"--dem", file, "--top"}));
  const double filled = teGroundShare(draw({"--dem", file, "--top", "--outside", "clamp"}));
  EXPECT_GT(filled, hole);
  draw({"--dem", file, "--outside", "-500"});
  EXPECT_EQ(report()["height_minimum_m"], -500);
  draw({"--dem", file, "--outside", "noise:amplitude=10"});
  EXPECT_LT(report()["height_minimum_m"], 10);
}

} // namespace
