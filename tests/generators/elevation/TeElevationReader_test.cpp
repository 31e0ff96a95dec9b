#include "generators/elevation/TeElevationReader.h"

#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(TeElevationReader, AnyPostCoordinatesHaveAHeightOrNone) {
  const TeTestFolder folder;
  TeElevationOptions options;
  options.encoding = TeElevationEncoding::Raw;
  options.rawColumns = 200;
  options.rawRows = 150;
  const auto file =
      TeElevationFile::open(folder.write("a.raw", teRaw(TeTestRaster::ramp(200, 150), false)), options);
  ASSERT_TRUE(file) << file.error().message;
  TeElevationReader reader(*file);
  const auto height = [&reader](double column, double row) {
    float found = -1;
    const TeStatus ok = reader.height({column, row}, found);
    EXPECT_TRUE(ok.ok());
    return found;
  };
  EXPECT_EQ(height(127.5, 127.5), 100 + 1275 + 127.5f); // four tiles meet
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(height(-infinity, -1e300), 100.0f);
  EXPECT_EQ(height(infinity, 1e300), 100 + 1490 + 199.0f);
  EXPECT_TRUE(std::isnan(height(NAN, 3)));
  EXPECT_TRUE(std::isnan(height(3, NAN)));
}
