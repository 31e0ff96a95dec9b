#include "generators/elevation/TeLocalFrame.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {

constexpr double kDegree = 0x1.1df46a2529d39p-6;
constexpr double kWgs84 = 6378137;
constexpr double kWgs84Flattening = 298.257223563;

TeLocalFrame rainier() {
  return TeLocalFrame::geographic(46.5 * kDegree, kDegree, kWgs84, kWgs84Flattening, {1, 1});
}

} // namespace

// Expected: gdaltransform -s_srs "+proj=longlat +ellps=WGS84"
//           -t_srs "+proj=ortho +lat_0=46.5 +lon_0=-121.5 +ellps=WGS84", and back (PROJ 9.1).
TEST(TeLocalFrame, TangentPlaneIsProjsOrthographic) {
  struct Pair {
    double longitude, latitude, x, y;
  };
  double worst = 0;
  for (const Pair& p : {Pair{-121.7603, 46.8523, -19851.7987160045, 39195.7246906691},
                        Pair{-122, 47, -38027.5164858758, 55702.6356749967},
                        Pair{-121, 46, 38731.1579555671, -55454.8088646507}, Pair{-121.5, 46.5, 0, 0}}) {
    TePlanePoint local;
    ASSERT_TRUE(rainier().toLocal({p.longitude + 121.5, p.latitude - 46.5}, local));
    worst = std::max({worst, std::fabs(local.x - p.x), std::fabs(local.y - p.y)});
  }
  std::printf("largest difference from PROJ %.3g m\n", worst);
  EXPECT_LT(worst, 1e-6);

  for (const Pair& p : {Pair{-121.000420703408, 46.9936811291912, 38000, 55000},
                        Pair{-121.888259913452, 46.1394847557624, -30000, -40000},
                        Pair{-118.937001872069, 45.5710931683592, 200000, -100000}}) {
    TePlanePoint offset;
    ASSERT_TRUE(rainier().toFile({p.x, p.y}, offset));
    EXPECT_NEAR(offset.x - 121.5, p.longitude, 1e-11);
    EXPECT_NEAR(offset.y + 46.5, p.latitude, 1e-11);
  }
}

TEST(TeLocalFrame, ThereAndBackIsTheSamePlace) {
  TeRandom random(3, 4, {});
  for (double latitude : {0.0, 46.5, -33.0, 89.9, -90.0}) {
    const TeLocalFrame tangent =
        TeLocalFrame::geographic(latitude * kDegree, kDegree, kWgs84, kWgs84Flattening, {10, 10});
    const TeLocalFrame plate =
        TeLocalFrame::geographic(latitude * kDegree * 0.9, kDegree, kWgs84, kWgs84Flattening, {360, 180});
    EXPECT_STREQ(tangent.name(), "tangent");
    EXPECT_STREQ(plate.name(), "plate");
    for (const TeLocalFrame& frame : {tangent, plate})
      for (int i = 0; i < 1000; ++i) {
        const TePlanePoint local{random.uniform(-5e5, 5e5), random.uniform(-5e5, 5e5)};
        TePlanePoint offset;
        TePlanePoint back;
        ASSERT_TRUE(frame.toFile(local, offset));
        ASSERT_TRUE(frame.toLocal(offset, back));
        EXPECT_NEAR(back.x, local.x, 1e-6) << frame.name() << " " << latitude;
        EXPECT_NEAR(back.y, local.y, 1e-6) << frame.name() << " " << latitude;
      }
  }
}

TEST(TeLocalFrame, SaysWhereThePlaneLeavesTheEarth) {
  TePlanePoint point;
  EXPECT_FALSE(rainier().toFile({7e6, 0}, point));
  EXPECT_FALSE(rainier().toFile({1e300, -1e300}, point));
  EXPECT_FALSE(rainier().toFile({NAN, 0}, point));
  EXPECT_FALSE(rainier().toFile({0, INFINITY}, point));
  EXPECT_TRUE(rainier().toFile({6e6, 0}, point));
  EXPECT_FALSE(rainier().toLocal({180, -60}, point));
}

TEST(TeLocalFrame, LinearCoordinatesAreScaled) {
  const TeLocalFrame feet = TeLocalFrame::linear(0.3048);
  TePlanePoint offset;
  ASSERT_TRUE(feet.toFile({304.8, -30.48}, offset));
  EXPECT_DOUBLE_EQ(offset.x, 1000);
  EXPECT_DOUBLE_EQ(offset.y, -100);
}
