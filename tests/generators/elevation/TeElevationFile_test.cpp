#include "generators/elevation/TeElevationFile.h"

#include "generators/TeHeightMap.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cmath>

namespace {

class ElevationFile : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto gdal = TeGdal::module(); !gdal)
      GTEST_SKIP() << gdal.error().message;
  }

  TeElevationFilePtr open(const std::string& path, const TeElevationOptions& options = {}) {
    const TeResult<TeElevationFilePtr> file = TeElevationFile::open(path, options);
    EXPECT_TRUE(file) << (file ? "" : file.error().message);
    return file ? *file : nullptr;
  }

  void expectPosts(const TeElevationFilePtr& file, const TeTestRaster& raster, double unit = 1) {
    ASSERT_TRUE(file);
    ASSERT_EQ(file->columns(), raster.columns);
    ASSERT_EQ(file->rows(), raster.rows);
    for (int r = 0; r < raster.rows; ++r)
      for (int c = 0; c < raster.columns; ++c) {
        const TeResult<float> height = file->post(c, r);
        ASSERT_TRUE(height) << height.error().message;
        ASSERT_EQ(*height, float(raster.at(c, r) * unit)) << c << "," << r;
      }
  }

  TeTestFolder folder;
  const TeTestRaster ramp = TeTestRaster::ramp(7, 5);
};

} // namespace

TEST_F(ElevationFile, ReadsEveryFormat) {
  TeElevationOptions terrarium;
  terrarium.encoding = TeElevationEncoding::Terrarium;
  const TeTestRaster tile = TeTestRaster::ramp(1201, 1201);
  const struct {
    std::string name, format, bytes;
  } files[] = {{"a.tif", "GTiff", teTiff(ramp, {})},
               {"a.png", "PNG", tePng16(ramp)},
               {"a.asc", "AAIGrid", teAsciiGrid(ramp, 30, "")},
               {"a.bt", "BT", teBinaryTerrain(ramp, 400000, 3800000, 30)},
               {"a.nc", "netCDF", teNetCdf(ramp, 10, 50, 0.01, "m", -1, 1)},
               {"a.dem", "USGSDEM", teUsgsDem(ramp, 399990, 3799980, 30, 7)}};
  for (const auto& f : files) {
    SCOPED_TRACE(f.name);
    const TeElevationFilePtr file = open(folder.write(f.name, f.bytes));
    expectPosts(file, ramp);
    EXPECT_EQ(file->format(), f.format);
  }
  expectPosts(open(folder.write("N46W122.hgt", teHgt(tile))), tile);
  expectPosts(open(folder.write("t.png", teTerrarium(ramp)), terrarium), ramp);
}

TEST_F(ElevationFile, ReadsEverySampleTypeOfATiff) {
  TeTestRaster raster = ramp;
  raster.samples[3] = 30000;
  for (TeTestSample sample :
       {TeTestSample::Int16, TeTestSample::UInt16, TeTestSample::Int32, TeTestSample::Float32}) {
    TeTestTiff tiff;
    tiff.sample = sample;
    expectPosts(open(folder.write("a.tif", teTiff(raster, tiff))), raster);
  }
}

TEST_F(ElevationFile, PostsOfAreasLieInTheirMiddleAndThoseOfPointsOnTheCorner) {
  TeTestTiff tiff;
  tiff.step = 30;
  tiff.west = 400000;
  tiff.north = 3800000;
  tiff.projected = 32611;
  const TeElevationFilePtr area = open(folder.write("area.tif", teTiff(ramp, tiff)));
  tiff.point = true;
  const TeElevationFilePtr point = open(folder.write("point.tif", teTiff(ramp, tiff)));
  ASSERT_TRUE(area && point);
  EXPECT_EQ(area->extent().width(), 7 * 30);
  EXPECT_EQ(area->extent().height(), 5 * 30);
  EXPECT_EQ(point->extent().width(), 6 * 30);
  EXPECT_EQ(point->extent().height(), 4 * 30);
  EXPECT_TRUE(area->contains({-0.5, 4.5}));
  EXPECT_FALSE(area->contains({-0.51, 0}));
  EXPECT_TRUE(point->contains({0, 4}));
  EXPECT_FALSE(point->contains({-0.01, 0}));

  // The same tie point is the corner of the first area, or the first post.
  TePlanePoint corner;
  ASSERT_TRUE(area->toLocal({-0.5, -0.5}, corner));
  const TeGeographicPosition a = *area->toGeographic(corner);
  ASSERT_TRUE(point->toLocal({0, 0}, corner));
  const TeGeographicPosition p = *point->toGeographic(corner);
  EXPECT_NEAR(a.longitude, p.longitude, 1e-12);
  EXPECT_NEAR(a.latitude, p.latitude, 1e-12);
}

// Expected: echo "-118.1 34.3" | gdaltransform -s_srs EPSG:4326 -t_srs EPSG:32611.
TEST_F(ElevationFile, ConvertsLongitudeAndLatitudeBothWays) {
  TeTestTiff tiff;
  tiff.step = 30;
  tiff.west = 398773.596559927 - 3.5 * 30;
  tiff.north = 3795967.81685182 + 2.5 * 30;
  tiff.projected = 32611;
  const TeElevationFilePtr file = open(folder.write("utm.tif", teTiff(ramp, tiff)));
  ASSERT_TRUE(file);
  const TeGeographicPosition centre = *file->toGeographic({0, 0});
  EXPECT_NEAR(centre.longitude, -118.1, 1e-10);
  EXPECT_NEAR(centre.latitude, 34.3, 1e-10);
  const TePlanePoint local = *file->fromGeographic({-118.1 + 360, 34.3});
  EXPECT_NEAR(local.x, 0, 1e-4);
  EXPECT_NEAR(local.y, 0, 1e-4);
  for (const TePlanePoint& wanted : {TePlanePoint{90, -60}, TePlanePoint{-10000, 25000}}) {
    const TePlanePoint back = *file->fromGeographic(*file->toGeographic(wanted));
    EXPECT_NEAR(back.x, wanted.x, 1e-4);
    EXPECT_NEAR(back.y, wanted.y, 1e-4);
  }
  EXPECT_FALSE(file->fromGeographic({NAN, 0}));
  EXPECT_FALSE(file->fromGeographic({0, 91}));
  EXPECT_FALSE(open(folder.write("plain.tif", teTiff(ramp, {})))->toGeographic({0, 0}));
}

TEST_F(ElevationFile, LongitudesMayBeCountedFromZeroTo360) {
  const TeElevationFilePtr file = open(folder.write("a.nc", teNetCdf(ramp, 240, 50, 0.01, "m", -1, 1)));
  ASSERT_TRUE(file);
  EXPECT_STREQ(file->frame().name(), "tangent");
  EXPECT_NEAR(file->toGeographic({0, 0})->longitude, -119.97, 1e-9);
  const TePlanePoint local = *file->fromGeographic({-119.97, 49.98});
  EXPECT_NEAR(local.x, 0, 1e-6);
  EXPECT_NEAR(local.y, 0, 1e-6);
}

TEST_F(ElevationFile, HonoursUnits) {
  TeTestTiff feet;
  feet.step = 100;
  feet.projected = 2225; // California zone 1, US survey feet
  feet.west = 6000000;
  feet.north = 2000000;
  EXPECT_NEAR(open(folder.write("ft.tif", teTiff(ramp, feet)))->postSpacing().x, 100 * 1200.0 / 3937, 1e-9);

  const TeElevationFilePtr tagged = open(folder.write("a.nc", teNetCdf(ramp, 10, 50, 0.01, "ft", -1, 0.5)));
  expectPosts(tagged, ramp, 0.5 * 0.3048);

  TeElevationOptions options;
  options.verticalUnit = 0.1;
  options.posts = 160;
  const TeElevationFilePtr decimetres = open(folder.write("a.png", tePng16(ramp)), options);
  expectPosts(decimetres, ramp, 0.1);
  EXPECT_EQ(decimetres->extent().width(), 6 * 160);
  EXPECT_EQ(*decimetres->nativeSpacing(), 160);

  TeElevationOptions degrees;
  degrees.horizontalUnit = TeHorizontalUnit::Degrees;
  TeTestTiff coarse;
  coarse.step = 1;
  coarse.west = 10;
  coarse.north = 50;
  const std::string path = folder.write("coarse.tif", teTiff(ramp, coarse));
  EXPECT_FALSE(open(path)->frame().isGeographic());
  EXPECT_TRUE(open(path, degrees)->frame().isGeographic());
}

// Bands of one file may differ in what their samples mean.
TEST_F(ElevationFile, TakesScaleUnitAndNoDataOfTheBandItReads) {
  const std::string path = folder.write("bands.png", teTerrarium(ramp)); // the second byte of 32768 + height
  folder.write("bands.png.aux.xml",
               "<PAMDataset>"
               "<PAMRasterBand band=\"1\"><NoDataValue>101</NoDataValue><UnitType>km</UnitType>"
               "<Offset>3</Offset><Scale>7</Scale></PAMRasterBand>"
               "<PAMRasterBand band=\"2\"><NoDataValue>100</NoDataValue><UnitType>ft</UnitType>"
               "<Offset>10</Offset><Scale>0.5</Scale></PAMRasterBand>"
               "</PAMDataset>");
  TeElevationOptions options;
  options.band = 2;
  const TeElevationFilePtr file = open(path, options);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->verticalUnit(), 0.3048);
  EXPECT_TRUE(TeHeightMap::isMissing(*file->post(0, 0)));
  EXPECT_EQ(*file->post(1, 0), float((101 * 0.5 + 10) * 0.3048));
  options.band = 4;
  EXPECT_FALSE(TeElevationFile::open(path, options));
}

TEST_F(ElevationFile, UnitNamesAreKnownInEveryCase) {
  EXPECT_EQ(*teVerticalUnit("Metre"), 1);
  EXPECT_EQ(*teVerticalUnit("FT"), 0.3048);
  EXPECT_EQ(*teVerticalUnit("us-feet"), 1200.0 / 3937);
  EXPECT_EQ(*teVerticalUnit("0.1"), 0.1);
  EXPECT_EQ(*teVerticalUnit("auto"), 0);
  for (const char* wrong : {"", "furlong", "-1", "0", "nan", "inf", "1e999", "1 m"})
    EXPECT_FALSE(teVerticalUnit(wrong)) << wrong;
}

TEST_F(ElevationFile, CoordinatesWithoutASystemAreDegreesOnlyIfTheyCanBe) {
  TeTestTiff tiff;
  tiff.step = 0.001;
  tiff.west = -105;
  tiff.north = 40;
  EXPECT_TRUE(open(folder.write("a.tif", teTiff(ramp, tiff)))->frame().isGeographic());
  tiff.west = 5000;
  EXPECT_FALSE(open(folder.write("b.tif", teTiff(ramp, tiff)))->frame().isGeographic());
  tiff.west = 0;
  tiff.step = 10;
  EXPECT_FALSE(open(folder.write("c.tif", teTiff(ramp, tiff)))->frame().isGeographic());
}

TEST_F(ElevationFile, OneSpacingCoversTheWholeFile) {
  TeElevationOptions options;
  options.posts = 10;
  const TeElevationFilePtr file = open(folder.write("a.tif", teTiff(ramp, {})), options);
  EXPECT_EQ(*file->coveringSpacing(3, 9), 60.0 / (3 * 4));
  EXPECT_FALSE(file->coveringSpacing(0, 9));
  EXPECT_FALSE(file->coveringSpacing(3, 8));
}

TEST_F(ElevationFile, NativePostsNeedOneSpacing) {
  TeTestTiff degrees;
  degrees.step = 0.001;
  degrees.geographic = 4326;
  degrees.west = 10;
  degrees.north = 50;
  EXPECT_FALSE(open(folder.write("a.tif", teTiff(ramp, degrees)))->nativeSpacing());
}

TEST_F(ElevationFile, RefusesWhatIsNoElevationFileInOneLine) {
  mkfifo(folder.path("pipe").c_str(), 0600);
  folder.write("empty", "");
  folder.write("text.txt", "hello, this is no elevation file\n");
  folder.write("vrt.tif", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"></VRTDataset>");
  folder.write("N00E000.hgt", std::string(1000, 'x'));
  for (const std::string& path :
       {folder.path("missing"), folder.path("pipe"), folder.path(""), folder.path("empty"),
        folder.path("text.txt"), folder.path("vrt.tif"), folder.path("N00E000.hgt"), std::string(),
        std::string("/vsicurl/http://127.0.0.1/a.tif"), std::string("/dev/zero"),
        std::string("NETCDF:\"a.nc\":z"), std::string("http://127.0.0.1/a.nc")}) {
    const auto file = TeElevationFile::open(path);
    ASSERT_FALSE(file) << path;
    EXPECT_EQ(file.error().message.find('\n'), std::string::npos);
    EXPECT_EQ(file.error().message.compare(0, path.size(), path), 0) << file.error().message;
  }
}

TEST_F(ElevationFile, RefusesImpossibleOptions) {
  const std::string path = folder.write("a.tif", teTiff(ramp, {}));
  for (auto change :
       {+[](TeElevationOptions& o) { o.band = 0; }, +[](TeElevationOptions& o) { o.band = 2; },
        +[](TeElevationOptions& o) { o.verticalUnit = NAN; }, +[](TeElevationOptions& o) { o.posts = -1; },
        +[](TeElevationOptions& o) { o.posts = INFINITY; },
        +[](TeElevationOptions& o) { o.fillDistance = 100000; },
        +[](TeElevationOptions& o) { o.variable = "z"; },
        +[](TeElevationOptions& o) { o.encoding = TeElevationEncoding::Terrarium; }}) {
    TeElevationOptions options;
    change(options);
    EXPECT_FALSE(TeElevationFile::open(path, options));
  }
}

TEST_F(ElevationFile, RefusesGeoreferencesThatMeanNothing) {
  for (auto change : {+[](TeTestTiff& t) { t.west = NAN; }, +[](TeTestTiff& t) { t.north = INFINITY; },
                      +[](TeTestTiff& t) { t.step = 1e300; }, +[](TeTestTiff& t) { t.step = 1e-30; },
                      +[](TeTestTiff& t) { t.north = 95; }, +[](TeTestTiff& t) { t.step = 100; }}) {
    TeTestTiff tiff;
    tiff.geographic = 4326;
    tiff.step = 0.01;
    tiff.north = 50;
    change(tiff);
    const auto file = TeElevationFile::open(folder.write("a.tif", teTiff(ramp, tiff)));
    EXPECT_FALSE(file) << (file ? (*file)->postSpacing().x : 0);
  }
}

TEST_F(ElevationFile, AFileThatChangedIsAnotherFile) {
  const std::uint64_t before = open(folder.write("a.tif", teTiff(ramp, {})))->fingerprint();
  EXPECT_EQ(open(folder.path("a.tif"))->fingerprint(), before);
  TeTestRaster changed = ramp;
  changed.samples[0] = 7;
  EXPECT_NE(open(folder.write("a.tif", teTiff(changed, {})))->fingerprint(), before);
}
