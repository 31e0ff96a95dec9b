#include "generators/circles/TeCircles.h"

#include "tests/generators/mapsInParts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Source = std::shared_ptr<const TeCircles>;

Source make(int circles = 1000) {
  TeCirclesParameters parameters;
  parameters.circles = circles;
  return *TeCircles::create(parameters);
}

TeMapRequest mapOf(int columns, int rows, TeMapKey key = {}, double spacing = 1) {
  TeMapRequest request = *TeMapRequest::standalone(columns, rows, spacing, 7);
  request.key = key;
  return request;
}

/// The document's loop: each circle over every sample of the map.
TeHeightMap plainLoop(const TeCircles& source, const TeMapRequest& request) {
  TeHeightMap map = *TeHeightMap::create(request.columns, request.rows);
  for (int i = 0; i < source.parameters().circles; ++i) {
    const TeCircle circle = source.circle(request, source.random(request), i);
    for (int r = 0; r < request.rows; ++r)
      for (int c = 0; c < request.columns; ++c)
        map.at(c, r) += circle.at(c, r);
  }
  return map;
}

} // namespace

TEST(TeCircles, MapsOfAnySizeHaveTheBitsOfThePlainLoop) {
  for (auto [columns, rows] : {std::pair(65, 65), {1, 1}, {1, 70}, {70, 1}, {2, 3}, {33, 130}, {3000, 2}})
    EXPECT_EQ(*make()->generate(mapOf(columns, rows)), plainLoop(*make(), mapOf(columns, rows)))
        << columns << "x" << rows;
  for (double spacing : {1e-9, 0.01, 30.0, 1e12})
    EXPECT_EQ(*make()->generate(mapOf(33, 33, {1, 2}, spacing)),
              plainLoop(*make(), mapOf(33, 33, {1, 2}, spacing)))
        << spacing;
}

TEST(TeCircles, AnySlicingGivesTheSameBits) {
  const Source source = make();
  const TeHeightMap whole = *source->generate(mapOf(65, 65));
  for (std::int64_t units : {1, 2, 7})
    expectMapInSlices(*source, mapOf(65, 65), units, whole);
}

TEST(TeCircles, ScatteredSamplesHaveTheBitsOfTheMap) {
  for (int stride : {1, 4, 32})
    expectSamplesOfMap(*make(), mapOf(65, 33, {4, -9}), stride);
}

// In a wide map most samples lie hundreds of thousands of radii from most circles.
TEST(TeCircles, SamplesFarFromACircleHaveTheBitsOfTheMapToo) {
  const Source source = make(100);
  const TeMapRequest request = mapOf(2000000, 1, {}, 20);
  const TeHeightMap map = *source->generate(request);
  for (int column : {0, 999999, 1999999}) {
    const TeMapSample sample{column, 0};
    float height = -1;
    ASSERT_TRUE(source->evaluate(request, &sample, 1, &height));
    EXPECT_EQ(height, map.at(column, 0)) << column;
  }
  TeCircle circle;
  circle.height = 10;
  EXPECT_EQ(circle.at(std::int64_t(1) << 30, -(std::int64_t(1) << 30)), 0.0f);
}

TEST(TeCircles, AHillIsACosineOverItsCircle) {
  const double pi = std::acos(-1.0);
  for (double radius : {1.0, 7.3, 16384.0}) {
    TeCircle circle;
    circle.column = 3;
    circle.row = -2;
    circle.eastward = 0.25f;
    circle.northward = 0.5f;
    circle.radius = radius;
    circle.height = 10;
    const int reach = int(1.2 * radius) + 3;
    for (int x = -reach; x <= reach; x += 1 + reach / 500) {
      const double d = std::hypot(x - 0.25, 1.0 - 0.5);
      const double expected = d < radius ? 5 * (1 + std::cos(pi * d / radius)) : 0;
      EXPECT_NEAR(circle.at(3 + x, -1), expected, 4e-6) << radius << " " << x;
      if (d > 1.001 * radius) {
        EXPECT_EQ(circle.at(3 + x, -1), 0.0f);
      }
    }
  }
}

TEST(TeCircles, BordersAreCoveredLikeTheMiddle) {
  const Source source = make();
  double border = 0, middle = 0;
  for (int k = 0; k < 200; ++k) {
    const TeMapRequest request = mapOf(33, 33, {k, 3});
    const TeMapSample samples[] = {{0, 0}, {16, 16}};
    float heights[2];
    ASSERT_TRUE(source->evaluate(request, samples, 2, heights));
    border += heights[0] * heights[0];
    middle += heights[1] * heights[1];
  }
  EXPECT_GT(border, 0.7 * middle);
  EXPECT_LT(border, 1.4 * middle);
}

TEST(TeCircles, CirclesStayWithinTheirParameters) {
  const Source source = make();
  const TeMapRequest request = mapOf(65, 65, {}, 0.5);
  int raised = 0;
  for (int i = 0; i < 1000; ++i) {
    const TeCircle circle = source->circle(request, source->random(request), i);
    EXPECT_GE(circle.radius, source->parameters().smallest / 0.5);
    EXPECT_LE(circle.radius, source->parameters().largest / 0.5);
    EXPECT_LE(std::fabs(circle.height),
              source->parameters().height * circle.radius * 0.5 / source->parameters().largest * 1.0001);
    EXPECT_GE(double(circle.column), -circle.radius - 2);
    EXPECT_LE(double(circle.column), 65 + circle.radius + 1);
    raised += circle.height > 0 ? 1 : 0;
  }
  EXPECT_NEAR(raised, 500, 100);
}

TEST(TeCircles, RefusesParametersOutOfRange) {
  const auto refused = [](auto change) {
    TeCirclesParameters parameters;
    change(parameters);
    return !TeCircles::create(parameters).ok();
  };
  EXPECT_TRUE(refused([](TeCirclesParameters& p) { p.circles = 0; }));
  EXPECT_TRUE(refused([](TeCirclesParameters& p) { p.smallest = 21; }));
  EXPECT_TRUE(refused([](TeCirclesParameters& p) { p.largest = NAN; }));
  EXPECT_TRUE(refused([](TeCirclesParameters& p) { p.height = -1; }));
  EXPECT_FALSE(refused([](TeCirclesParameters& p) { p.smallest = p.largest; }));
}
