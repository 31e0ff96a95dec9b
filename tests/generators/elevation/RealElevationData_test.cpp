#include "generators/TeHeightMap.h"
#include "generators/elevation/TeElevationScan.h"
#include "generators/elevation/TeElevationSource.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

// Real files against what gdallocationinfo -valonly and gdalinfo -stats (GDAL 3.6.2) say of them.

namespace {

struct Post {
  int column;
  int row;
  float height; ///< NaN = no data
};

struct RealFile {
  const char* name;
  int columns;
  int rows;
  float minimum;
  float maximum;
  std::int64_t missing;
  std::vector<Post> posts;
};

const float kNone = NAN;

const RealFile kFiles[] = {
    {"geotiff/mt_rainier_90m.tif",
     1201,
     1201,
     263,
     4371,
     9033,
     {{287, 177, 4371}, {0, 0, 487}, {1200, 1200, 1115}, {600, 600, 1849}, {100, 900, 1151}}},
    {"geotiff/elev16_wgs84_512x512.tif",
     512,
     512,
     49,
     1772,
     0,
     {{90, 5, 1772}, {0, 0, 1123}, {511, 511, 1381}, {256, 100, 293}}},
    {"geotiff/elev32_nad83_512x512.tif",
     512,
     512,
     49.5293617f,
     1772.52856445312f,
     0,
     {{0, 0, 1123.04174804688f}, {511, 511, 1381.39367675781f}, {256, 100, 293.121520996094f}}},
    {"geotiff/bigtujunga.tif",
     1197,
     643,
     315,
     2295,
     0,
     {{1196, 247, 2295}, {0, 0, 945}, {600, 300, 1201}, {5, 642, 351}}},
    {"geotiff/valid_raster.tif",
     100,
     80,
     26.57922744751f,
     44.072563171387f,
     970,
     {{99, 7, 44.0725631713867f}, {50, 40, 33.2828979492188f}, {0, 0, kNone}, {30, 60, 32.9879531860352f}}},
    {"hgt/N27E088.hgt",
     1201,
     1201,
     185,
     8556,
     6,
     {{177, 357, 8556}, {0, 0, 5744}, {1200, 1200, 1108}, {600, 600, 1720}}},
    {"hgt/N57E011.hgt", 1201, 1201, -13, 164, 0, {{1200, 11, 164}, {0, 0, 0}, {700, 700, 0}}},
    {"ascii/SRTMGL3_colorado_front_range.asc",
     240,
     144,
     1943,
     3286,
     0,
     {{3, 70, 3286}, {0, 0, 2569}, {239, 143, 2028}}},
    {"ascii/hugo_site.asc", 76, 55, 1660, 1711, 2028, {{59, 48, 1711}, {0, 0, kNone}, {40, 30, 1684}}},
    {"ascii/pre_runout_DEM.asc",
     80,
     122,
     189.028f,
     582.384582519531f,
     122,
     {{25, 0, 582.384582519531f}, {40, 60, 339.973907470703f}}},
    {"bt/oregon_512_float32.bt",
     512,
     512,
     49.5293617f,
     1772.52856445312f,
     0,
     {{90, 5, 1772.52856445312f}, {256, 100, 293.121520996094f}}},
    {"bt/rainier_513_int16.bt", 513, 513, 300, 4371, 4673, {{187, 177, 4371}, {300, 300, 1458}}},
    {"usgsdem/bigtujunga_400x300_utm11.dem",
     400,
     301,
     533,
     1888,
     400,
     {{198, 7, 1888}, {0, 0, kNone}, {100, 100, 1501}, {399, 299, 1588}}},
    {"png16/ps_height_1k.png",
     1025,
     1025,
     0,
     43798,
     0,
     {{803, 529, 43798}, {0, 0, 6387}, {512, 512, 1969}, {100, 900, 4063}}},
};

void expectPosts(const TeElevationFile& file, const std::vector<Post>& posts) {
  for (const Post& post : posts) {
    const TeResult<float> height = file.post(post.column, post.row);
    ASSERT_TRUE(height) << height.error().message;
    if (TeHeightMap::isMissing(post.height))
      EXPECT_TRUE(TeHeightMap::isMissing(*height)) << post.column << "," << post.row;
    else
      EXPECT_EQ(*height, post.height) << post.column << "," << post.row;
  }
}

class RealElevationData : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto gdal = TeGdal::module(); !gdal)
      GTEST_SKIP() << gdal.error().message;
    if (teTestData("README.md").empty())
      GTEST_SKIP() << "no test data";
  }

  TeElevationFilePtr open(const std::string& name, const TeElevationOptions& options = {}) {
    const auto file = TeElevationFile::open(teTestData(name), options);
    EXPECT_TRUE(file) << (file ? "" : file.error().message);
    return file ? *file : nullptr;
  }
};

} // namespace

TEST_F(RealElevationData, PostsAreThoseThatGdalTells) {
  for (const RealFile& real : kFiles) {
    SCOPED_TRACE(real.name);
    const TeElevationFilePtr file = open(real.name);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->columns(), real.columns);
    EXPECT_EQ(file->rows(), real.rows);
    const auto summary = TeElevationScan::summarise(file);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_NEAR(summary->minimum, real.minimum, 0.0005);
    EXPECT_EQ(summary->maximum, real.maximum);
    EXPECT_EQ(summary->missing, real.missing);
    expectPosts(*file, real.posts);
  }
}

TEST_F(RealElevationData, EveryVoidOfRainierIsFilledBetweenItsSurroundings) {
  TeElevationOptions options;
  options.fillDistance = 100;
  const auto holes = TeElevationScan::summarise(open("geotiff/mt_rainier_90m.tif"));
  const auto filled = TeElevationScan::summarise(open("geotiff/mt_rainier_90m.tif", options));
  ASSERT_TRUE(holes && filled);
  EXPECT_EQ(holes->missing, 9033);
  EXPECT_EQ(filled->missing, 0);
  EXPECT_EQ(filled->minimum, 263);
  EXPECT_EQ(filled->maximum, 4371);
}

TEST_F(RealElevationData, TheSummitOfRainierIsAtItsLongitudeAndLatitude) {
  const TeElevationFilePtr file = open("geotiff/mt_rainier_90m.tif");
  ASSERT_TRUE(file);
  const TePlanePoint summit = *file->fromGeographic({-121.7603, 46.8523});
  EXPECT_NEAR(summit.x, -19851.7987160045, 1e-6); // by PROJ, see TeLocalFrame_test
  EXPECT_NEAR(summit.y, 39195.7246906691, 1e-6);
  TeElevationPlacement placement;
  placement.origin = summit;
  const auto source = TeElevationSource::create(file, placement);
  const auto map = (*source)->generate(TeMapRequest::sourceMap(*TeLattice::create(65, 10), 0, {0, 0}));
  EXPECT_GT(map->statistics().maximum, 4365);
}

TEST_F(RealElevationData, PugetSoundHasPostsOf160MetresInDecimetres) {
  TeElevationOptions options;
  options.posts = 160;
  options.verticalUnit = 0.1;
  const TeElevationFilePtr file = open("png16/ps_height_1k.png", options);
  ASSERT_TRUE(file);
  expectPosts(*file, {{803, 529, float(43798 * 0.1)}, {512, 512, float(1969 * 0.1)}});
  EXPECT_EQ(*file->nativeSpacing(), 160);
  EXPECT_EQ(file->extent().width(), 1024 * 160);
  EXPECT_EQ(*file->coveringSpacing(1, 65), 1024.0 * 160 / 32);
}

TEST_F(RealElevationData, TerrariumColoursAreHeights) {
  TeElevationOptions options;
  options.encoding = TeElevationEncoding::Terrarium;
  const TeElevationFilePtr file = open("rgbtiles/terrarium_256.png", options);
  ASSERT_TRUE(file);
  expectPosts(*file, {{232, 242, 256 * 137 + 171 + 17 / 256.0f - 32768},
                      {0, 0, 256 * 131 + 101 + 33 / 256.0f - 32768},
                      {128, 128, 256 * 133 + 64 + 143 / 256.0f - 32768}});
}

TEST_F(RealElevationData, TheSameAreaHasTheSameHeightsInThreeFormats) {
  const TeElevationFilePtr tiff = open("geotiff/elev32_nad83_512x512.tif");
  const TeElevationFilePtr bt = open("bt/oregon_512_float32.bt");
  ASSERT_TRUE(tiff && bt);
  for (int r = 0; r < 512; r += 3)
    for (int c = 0; c < 512; c += 3)
      ASSERT_EQ(*tiff->post(c, r), *bt->post(c, r));
}

TEST_F(RealElevationData, NetCdfOfTheWholeEarth) {
  const char* path = "/usr/share/ferret-vis/data/etopo5.cdf";
  if (!std::filesystem::exists(path))
    GTEST_SKIP() << path << " is not there (Debian package ferret-datasets)";
  const auto file = TeElevationFile::open(path);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_STREQ((*file)->frame().name(), "plate");
  expectPosts(**file, {{901, 644, 7833}, {0, 1080, -4876}, {2000, 1000, -4669}});
  EXPECT_NEAR((*file)->extent().width(), 40075386.9, 1);
  const auto summary = TeElevationScan::summarise(*file);
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->minimum, -10376);
  EXPECT_EQ(summary->maximum, 7833);
}

TEST_F(RealElevationData, NetCdfInFeetWithoutATag) {
  const char* path = "/usr/share/ncarg/data/cdf/trinidad.nc";
  if (!std::filesystem::exists(path))
    GTEST_SKIP() << path << " is not there (Debian package libncarg-data)";
  TeElevationOptions options;
  options.verticalUnit = 0.3048;
  const auto file = TeElevationFile::open(path, options);
  ASSERT_TRUE(file) << file.error().message;
  expectPosts(**file, {{617, 508, float(14176.16015625 * 0.3048)}, {0, 0, float(7517.759765625 * 0.3048)}});
  // Blanca Peak, 4374 m.
  const TePlanePoint peak = *(*file)->fromGeographic({-105.4856, 37.5775});
  TePlanePoint posts;
  ASSERT_TRUE((*file)->toPosts(peak, posts));
  EXPECT_NEAR(posts.x, 617, 3);
  EXPECT_NEAR(posts.y, 508, 3);
}
