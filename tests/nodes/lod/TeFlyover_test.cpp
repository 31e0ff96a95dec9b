#include "nodes/lod/TeFlyover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

/// 1024 cells of 10 m, heights in units of 3 cm, one peak at (peakColumn, peakRow).
TeFlyover withPeak(int peakColumn, int peakRow) {
  TeFlyover flight;
  flight.cells = 1024;
  flight.spacing = 10;
  flight.heightScale = 0.03;
  flight.sample = [=](std::int32_t column, std::int32_t row) {
    return column == peakColumn && row == peakRow ? 1000.0f : 100.0f;
  };
  return flight;
}

TEST(TeFlyover, BeginsInTheEastAndFliesNorthEightDegreesDown) {
  const TePerspectiveView view = withPeak(0, 0).view(0);
  EXPECT_NEAR(view.eye.x, 8192, 1e-9);
  EXPECT_NEAR(view.eye.y, 5120, 1e-9);
  EXPECT_NEAR(view.eye.z, 153, 1e-9);
  EXPECT_NEAR(view.forward.x, 0, 1e-12);
  EXPECT_NEAR(view.forward.y, std::cos(8 * 3.14159265358979323846 / 180), 1e-12);
  EXPECT_NEAR(view.forward.z, -std::sin(8 * 3.14159265358979323846 / 180), 1e-12);
  EXPECT_NEAR(view.lodView().focal, 665.1, 0.05);
}

TEST(TeFlyover, AQuarterOfTheCircleIs180Frames) {
  const TePerspectiveView view = withPeak(0, 0).view(180);
  EXPECT_NEAR(view.eye.x, 5120, 1e-9);
  EXPECT_NEAR(view.eye.y, 8192, 1e-9);
  EXPECT_NEAR(view.forward.y, 0, 1e-12);
  EXPECT_LT(view.forward.x, -0.99);
  const TePerspectiveView again = withPeak(0, 0).view(180 + 720);
  EXPECT_NEAR(view.eye.x, again.eye.x, 1e-6);
  EXPECT_NEAR(view.eye.y, again.eye.y, 1e-6);
}

TEST(TeFlyover, KeepsClearOfSamplesWithinFourCells) {
  // The eye is at column 819.2, row 512.
  for (const auto& [column, row] : {std::pair(816, 512), {823, 512}, {819, 508}, {819, 516}})
    EXPECT_NEAR(withPeak(column, row).view(0).eye.z, 180, 1e-9) << column << " " << row;
  for (const auto& [column, row] : {std::pair(815, 512), {824, 512}, {819, 507}, {819, 517}})
    EXPECT_NEAR(withPeak(column, row).view(0).eye.z, 153, 1e-9) << column << " " << row;
}

TEST(TeFlyover, AsksForNoSampleOutsideOfTheTerrain) {
  TeFlyover flight = withPeak(0, 0);
  flight.radius = 0.5;
  std::int32_t least = 0, most = 0;
  flight.sample = [&](std::int32_t column, std::int32_t row) {
    least = std::min({least, column, row});
    most = std::max({most, column, row});
    return 0.0f;
  };
  for (int frame = 0; frame < 720; frame += 60)
    flight.view(frame);
  EXPECT_EQ(least, 0);
  EXPECT_EQ(most, 1024);
}

} // namespace
