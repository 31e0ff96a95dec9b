#include "nodes/lod/TeScreenError.h"

#include "generators/base/TeRandom.h"
#include "nodes/lod/TePerspectiveView.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using Vertex = TeScreenError::Vertex;
using Triangle = std::array<Vertex, 3>;

TeHeightMap randomMap(int side) {
  TeHeightMap map = *TeHeightMap::create(side, side);
  TeRandom random(7, 0, TeMapKey{});
  for (int i = 0; i < side * side; i++)
    map.data()[i] = float(random.below(2000));
  return map;
}

Vertex vertexOf(const TeHeightMap& map, int column, int row) { return {column, row, map.at(column, row)}; }

/// Two triangles over every cell of step × step samples.
std::vector<Triangle> grid(const TeHeightMap& map, int step) {
  std::vector<Triangle> triangles;
  for (int y = 0; y + step < map.height(); y += step)
    for (int x = 0; x + step < map.width(); x += step) {
      const Vertex a = vertexOf(map, x, y), b = vertexOf(map, x + step, y);
      const Vertex c = vertexOf(map, x + step, y + step), d = vertexOf(map, x, y + step);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return triangles;
}

TeScreenError::Report measured(const TeHeightMap& map, const std::vector<Triangle>& triangles,
                               const TeLodView& view) {
  TeScreenError error(map, {100, -50, 10}, 10, 0.5);
  for (const Triangle& triangle : triangles)
    error.add(triangle[0], triangle[1], triangle[2]);
  return error.measure(view);
}

glm::dvec3 positionOf(int column, int row, double height) {
  return {100 + column * 10, -50 + row * 10, 10 + height * 0.5};
}

TeLodView lookingIn() {
  TePerspectiveView view;
  view.eye = {-100, 60, 800};
  view.forward = glm::normalize(glm::dvec3(1, 0.5, -1));
  return view.lodView();
}

/// The same by another way: each sample asks each triangle.
struct Slow {
  std::int64_t samples = 0, uncovered = 0;
  double worstMetres = 0;
  std::vector<double> pixels;
};

Slow slowly(const TeHeightMap& map, const std::vector<Triangle>& triangles, const TeLodView& view) {
  Slow slow;
  for (int row = 0; row < map.height(); row++)
    for (int column = 0; column < map.width(); column++) {
      const glm::dvec3 position = positionOf(column, row, map.at(column, row));
      if (!view.meets(position, position))
        continue;
      slow.samples++;
      double deviation = -1;
      for (const auto& [a, b, c] : triangles) {
        const auto area = [](double x0, double y0, double x1, double y1) { return x0 * y1 - x1 * y0; };
        const double whole = area(b.column - a.column, b.row - a.row, c.column - a.column, c.row - a.row);
        const double ofB = area(column - a.column, row - a.row, c.column - a.column, c.row - a.row) / whole;
        const double ofC = area(b.column - a.column, b.row - a.row, column - a.column, row - a.row) / whole;
        if (ofB < -1e-12 || ofC < -1e-12 || ofB + ofC > 1 + 1e-12)
          continue;
        const double height = (1 - ofB - ofC) * a.height + ofB * b.height + ofC * c.height;
        deviation = std::max(deviation, std::fabs(double(map.at(column, row)) - height));
      }
      if (deviation < 0) {
        slow.uncovered++;
        continue;
      }
      slow.worstMetres = std::max(slow.worstMetres, deviation * 0.5);
      slow.pixels.push_back(view.pixels(deviation * 0.5, glm::distance(view.eye, position)));
    }
  std::sort(slow.pixels.begin(), slow.pixels.end());
  return slow;
}

void expectSame(const TeHeightMap& map, const std::vector<Triangle>& triangles, const TeLodView& view) {
  const TeScreenError::Report report = measured(map, triangles, view);
  const Slow slow = slowly(map, triangles, view);
  EXPECT_EQ(report.samples, slow.samples);
  EXPECT_EQ(report.uncovered, slow.uncovered);
  EXPECT_NEAR(report.worstMetres, slow.worstMetres, 1e-4);
  ASSERT_FALSE(slow.pixels.empty());
  EXPECT_NEAR(report.worst, slow.pixels.back(), 1e-5 * slow.pixels.back());
  const std::size_t rank = std::size_t(std::ceil(0.999 * double(slow.pixels.size()))) - 1;
  EXPECT_NEAR(report.quantile, slow.pixels[rank], 1e-5 * slow.pixels.back());
  double squares = 0;
  for (const double pixels : slow.pixels)
    squares += pixels * pixels;
  EXPECT_NEAR(report.rms, std::sqrt(squares / double(slow.pixels.size())), 1e-5 * slow.pixels.back());
}

} // namespace

TEST(TeScreenError, NothingWhereEverySampleIsAVertex) {
  const TeHeightMap map = randomMap(33);
  const TeScreenError::Report report = measured(map, grid(map, 1), TeLodView());
  EXPECT_EQ(report.samples, 33 * 33);
  EXPECT_EQ(report.uncovered, 0);
  EXPECT_EQ(report.worst, 0);
  EXPECT_EQ(report.worstMetres, 0);
  EXPECT_EQ(report.overlaps, 0);
  EXPECT_EQ(report.triangles, 2 * 32 * 32);
}

TEST(TeScreenError, IsTheDeviationTimesFocalOverDistance) {
  TeHeightMap map = *TeHeightMap::create(5, 5);
  map.at(2, 1) = 300;
  TeLodView view;
  view.focal = 600;
  view.eye = positionOf(2, 1, 300) + glm::dvec3(0, 0, 400);
  const TeScreenError::Report report = measured(map, grid(map, 4), view);
  EXPECT_DOUBLE_EQ(report.worst, 150 * 600 / 400.0);
  EXPECT_DOUBLE_EQ(report.worstMetres, 150);
  EXPECT_EQ(report.worstColumn, 2);
  EXPECT_EQ(report.worstRow, 1);
  EXPECT_DOUBLE_EQ(report.rms, report.worst / 5);
  EXPECT_FLOAT_EQ(float(report.quantile), float(report.worst));

  view.perspective = false;
  EXPECT_DOUBLE_EQ(measured(map, grid(map, 4), view).worst, 150 * 600);
  view.perspective = true;
  view.eye = positionOf(2, 1, 300);
  EXPECT_EQ(measured(map, grid(map, 4), view).worst, std::numeric_limits<double>::infinity());
}

TEST(TeScreenError, OneSampleInAThousandIsAboveTheQuantile) {
  TeHeightMap map = *TeHeightMap::create(101, 101); // 10201 samples
  for (int i = 0; i < 11; i++)
    map.at(5 + 8 * i, 50) = float(100 * (i + 1));
  TeLodView view;
  view.perspective = false;
  const std::vector<Triangle> flat = {{Vertex{0, 0, 0}, {100, 0, 0}, {100, 100, 0}},
                                      {Vertex{0, 0, 0}, {100, 100, 0}, {0, 100, 0}}};
  EXPECT_FLOAT_EQ(float(measured(map, flat, view).quantile), 50); // 10 are above, 10.2 may be
}

TEST(TeScreenError, AgreesWithAskingEveryTriangle) {
  const TeHeightMap map = randomMap(33);
  for (const int step : {2, 4, 32})
    expectSame(map, grid(map, step), lookingIn());

  TeRandom random(3, 0, TeMapKey{});
  for (int trial = 0; trial < 30; trial++) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 5; i++) {
      Triangle triangle;
      for (Vertex& vertex : triangle)
        vertex = {std::int32_t(random.below(33)), std::int32_t(random.below(33)), float(random.below(999))};
      triangles.push_back(triangle);
    }
    const auto noArea = [](const Triangle& t) {
      return (t[1].column - t[0].column) * (t[2].row - t[0].row) ==
             (t[2].column - t[0].column) * (t[1].row - t[0].row);
    };
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), noArea), triangles.end());
    SCOPED_TRACE(trial);
    expectSame(map, triangles, lookingIn());
  }
}

TEST(TeScreenError, HolesAreCounted) {
  const TeHeightMap map = randomMap(9);
  std::vector<Triangle> triangles = grid(map, 4);
  triangles.erase(triangles.begin()); // the corner (4, 0) and the edges that no other triangle has
  const TeScreenError::Report report = measured(map, triangles, TeLodView());
  EXPECT_EQ(report.samples, 81);
  EXPECT_EQ(report.uncovered, 3 + 3); // on the rim, and inside
  EXPECT_EQ(measured(map, {}, TeLodView()).uncovered, 81);
  EXPECT_EQ(measured(map, {}, TeLodView()).worst, 0);
}

TEST(TeScreenError, OverlapsAreCounted) {
  const TeHeightMap map = randomMap(17);
  for (const int step : {1, 2, 4, 8, 16}) {
    std::vector<Triangle> triangles = grid(map, step);
    EXPECT_EQ(measured(map, triangles, TeLodView()).overlaps, 0) << step;
    triangles.push_back({vertexOf(map, 3, 3), vertexOf(map, 3, 12), vertexOf(map, 12, 3)});
    EXPECT_GT(measured(map, triangles, TeLodView()).overlaps, 30) << step;
  }
  // A fan of triangles of many slopes has its samples once.
  std::vector<Triangle> fan;
  for (int i = 0; i < 16; i++)
    fan.push_back({vertexOf(map, 5, 0), vertexOf(map, i + 1, 16), vertexOf(map, i, 16)});
  EXPECT_EQ(measured(map, fan, TeLodView()).overlaps, 0);
}

TEST(TeScreenError, MissingSamplesAreNotInView) {
  TeHeightMap map = randomMap(9);
  map.at(3, 3) = TeHeightMap::missing();
  for (const bool perspective : {true, false}) {
    TeLodView view;
    view.perspective = perspective;
    const TeScreenError::Report report = measured(map, grid(map, 2), view);
    EXPECT_EQ(report.samples, 80);
    EXPECT_EQ(report.uncovered, 0);
    EXPECT_TRUE(std::isfinite(report.rms));
  }
}

TEST(TeScreenError, TrianglesThatAreNoneAreLeftOut) {
  const TeHeightMap map = randomMap(5);
  TeScreenError error(map, glm::dvec3(0), 1, 1);
  const int huge = std::numeric_limits<std::int32_t>::max();
  error.add({0, 0, 0}, {2, 2, 0}, {4, 4, 0});
  error.add({0, 0, 0}, {5, 0, 0}, {0, 4, 0});
  error.add({0, 0, 0}, {-1, 0, 0}, {0, 4, 0});
  error.add({huge, huge, 0}, {-huge, 0, 0}, {0, -huge, 0});
  error.add({0, 0, 0}, {4, 0, std::numeric_limits<float>::quiet_NaN()}, {0, 4, 0});
  EXPECT_EQ(error.measure(TeLodView()).foreign, 5);
  EXPECT_EQ(error.measure(TeLodView()).triangles, 0);
  error.clear();
  EXPECT_EQ(error.measure(TeLodView()).foreign, 0);
}
