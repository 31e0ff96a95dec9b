#include "generators/TeHeightMap.h"
#include "generators/elevation/TeElevationSource.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdio>

namespace {

struct Case {
  const char* what;
  TeTestSample type;
  double value;    ///< as stored
  const char* tag; ///< the file's own declaration
  double declared; ///< by option; NaN = not
  double unit;     ///< metres of a stored step
};

/// Of a map with two samples a post, those at the posts 0, (4, 4), (5, 4), 80 and within a cell of them.
constexpr int kMissing = 3 * 5 + 4 + 4;

const Case kCases[] = {
    {"NaN", TeTestSample::Float32, NAN, "", NAN, 1},
    {"NaN with another tag", TeTestSample::Float32, NAN, "-9999", NAN, 1},
    {"+Inf", TeTestSample::Float32, INFINITY, "", NAN, 1},
    {"-Inf", TeTestSample::Float32, -INFINITY, "", NAN, 1},
    {"-32768 of 16 bits", TeTestSample::Int16, -32768, "", NAN, 1},
    {"-32768 of 16 bits in decimetres", TeTestSample::Int16, -32768, "", NAN, 0.1},
    {"-32768 of 32 bits", TeTestSample::Int32, -32768, "", NAN, 1},
    {"-32768 in single precision", TeTestSample::Float32, -32768, "", NAN, 1},
    {"FLT_MAX", TeTestSample::Float32, FLT_MAX, "", NAN, 1},
    {"-FLT_MAX", TeTestSample::Float32, -FLT_MAX, "", NAN, 1},
    {"-FLT_MAX by a rounded tag", TeTestSample::Float32, -FLT_MAX, "-3.40282346639e+38", NAN, 1},
    {"FLT_MAX in millimetres", TeTestSample::Float32, FLT_MAX, "", NAN, 0.001},
    {"+999 by tag", TeTestSample::Int16, 999, "999", NAN, 1},
    {"+999 by option", TeTestSample::Float32, 999, "", 999, 1},
    {"0 by tag", TeTestSample::Int16, 0, "0", NAN, 1},
    {"0 by option", TeTestSample::Float32, 0, "", 0, 1},
    {"-9999.9 by a tag of more digits", TeTestSample::Float32, -9999.9f, "-9999.9", NAN, 1},
    {"2^31-1", TeTestSample::Int32, 2147483647, "", NAN, 1},
    {"-2^31", TeTestSample::Int32, -2147483648.0, "", NAN, 1},
};

} // namespace

// Every kind of "no data" is a hole, or filled if that is asked for, and never a height.
TEST(HardCase, NaNAndNoData) {
  if (const auto gdal = TeGdal::module(); !gdal)
    GTEST_SKIP() << gdal.error().message;
  const TeTestFolder folder;
  int holes = 0;
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    TeTestRaster raster = TeTestRaster::ramp(9, 9);
    for (int i : {0, 4 * 9 + 4, 4 * 9 + 5, 80})
      raster.samples[std::size_t(i)] = c.value;
    TeTestTiff tiff;
    tiff.sample = c.type;
    tiff.noData = c.tag;
    const std::string path = folder.write("a.tif", teTiff(raster, tiff));
    for (int fill : {0, 5}) {
      TeElevationOptions options;
      options.posts = 10;
      options.verticalUnit = c.unit;
      options.fillDistance = fill;
      if (!std::isnan(c.declared))
        options.noData = {c.declared};
      const auto file = TeElevationFile::open(path, options);
      ASSERT_TRUE(file) << file.error().message;
      const auto source = TeElevationSource::create(*file, {});
      ASSERT_TRUE(source);
      TeMapRequest request = *TeMapRequest::standalone(17, 17, 5, 0);
      request.firstX = request.firstY = -8;
      const TeHeightMap map = *(*source)->generate(request);
      for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 17; ++x) {
          if (TeHeightMap::isMissing(map.at(x, y)))
            continue;
          ASSERT_GE(map.at(x, y), float(100 * c.unit)) << x << "," << y;
          ASSERT_LE(map.at(x, y), float(188 * c.unit)) << x << "," << y;
        }
      EXPECT_EQ(map.statistics().missing, fill > 0 ? 0 : kMissing);
      if (fill == 0) {
        EXPECT_TRUE(TeHeightMap::isMissing(*(*file)->post(4, 4)));
        holes += int(map.statistics().missing);
      }
    }
  }
  std::printf("%zu kinds of no data: %d samples missing, none a height\n", std::size(kCases), holes);
}
