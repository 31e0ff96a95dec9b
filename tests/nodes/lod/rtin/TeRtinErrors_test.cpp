#include "nodes/lod/rtin/TeRtinErrors.h"

#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/rtin/TeRtinTile.h"
#include "nodes/lod/rtin/TeRtinTriangle.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using Corner = TeRtinTriangle::Corner;

std::size_t indexOf(const TeHeightMap& map, const Corner& corner) {
  return std::size_t(corner.row) * std::size_t(map.width()) + std::size_t(corner.column);
}

TeLodVertex vertexOf(const TeHeightMap& map, const Corner& corner) {
  return {corner.column, corner.row, map.at(corner.column, corner.row)};
}

/// The error of a triangle by itself: all samples looked at, or that in the middle of its hypotenuse.
double ownError(const TeHeightMap& map, const TeRtinTriangle& triangle, TeRtinError error) {
  if (error == TeRtinError::Exact)
    return double(teTriangleDeviation(map, vertexOf(map, triangle.a()), vertexOf(map, triangle.b()),
                                      vertexOf(map, triangle.apex())));
  const double ends =
      0.5 * (double(vertexOf(map, triangle.a()).height) + double(vertexOf(map, triangle.b()).height));
  return std::fabs(double(vertexOf(map, triangle.middle()).height) - ends);
}

/// All triangles of a depth, by the definition: errors of their vertices, at least those one step deeper.
void raiseDepth(const TeHeightMap& map, const TeRtinTriangle& triangle, int depth, TeRtinError error,
                std::vector<double>& errors) {
  if (depth > 0) {
    raiseDepth(map, triangle.firstHalf(), depth - 1, error, errors);
    raiseDepth(map, triangle.secondHalf(), depth - 1, error, errors);
    return;
  }
  double& raised = errors[indexOf(map, triangle.middle())];
  raised = std::max(raised, ownError(map, triangle, error));
  for (const TeRtinTriangle& half : {triangle.firstHalf(), triangle.secondHalf()})
    if (!half.isSmallest())
      raised = std::max(raised, errors[indexOf(map, half.middle())]);
}

std::vector<double> errorsByDefinition(const TeHeightMap& map, TeRtinError error) {
  std::vector<double> errors(std::size_t(map.width()) * std::size_t(map.width()));
  int log = 0;
  while (1 << log < map.width() - 1)
    log++;
  for (int depth = 2 * log - 1; depth >= 0; depth--)
    for (const int half : {0, 1})
      raiseDepth(map, TeRtinTriangle::root(log, half), depth, error, errors);
  return errors;
}

} // namespace

TEST(TeRtinErrors, AreThoseOfTheDefinition) {
  std::mt19937 random(1);
  for (const TeRtinError error : {TeRtinError::Exact, TeRtinError::Midpoint})
    for (int cells = 2; cells <= 256; cells *= 2)
      for (int kind = 0; kind <= int(StressField::Flat); kind++) {
        const TeHeightMap map = stressMap(StressField(kind), cells, random);
        const double highest = double(map.statistics().maximum);
        const std::vector<double> wanted = errorsByDefinition(map, error);
        const std::vector<float> found = TeRtinErrors::create(map, error);
        for (std::size_t i = 0; i < wanted.size(); i++)
          // Midpoint errors are computed in single precision.
          ASSERT_NEAR(double(found[i]), wanted[i], 2e-7 * (error == TeRtinError::Exact ? wanted[i] : highest))
              << "cells " << cells << " field " << kind << " sample " << i;
      }
}

// Larger than what is measured in tiles, on ground where the search must find single samples.
TEST(TeRtinErrors, SearchFindsTheWorstSample) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 4; trial++) {
    TeHeightMap map = stressMap(StressField::Rough, 512, random);
    for (int spike = 0; spike < 40; spike++)
      map.at(int(random() % 513), int(random() % 513)) += float(random() % 60) - 30;
    const std::vector<double> wanted = errorsByDefinition(map, TeRtinError::Exact);
    const std::vector<float> found = TeRtinErrors::create(map, TeRtinError::Exact);
    for (std::size_t i = 0; i < wanted.size(); i++)
      ASSERT_NEAR(double(found[i]), wanted[i], 2e-7 * wanted[i]) << i;
  }
}

TEST(TeRtinErrors, DoNotDependOnTheWidthOfVectors) {
  std::mt19937 random(3);
  for (const int cells : {2, 4, 16, 128}) {
    const TeHeightMap map = stressMap(StressField::Rough, 128, random);
    std::vector<std::vector<float>> all;
    for (int lanes = 2; lanes <= TeRtinTile::mostLanes(); lanes *= 2) {
      all.emplace_back(129 * 129, 0.0f);
      TeRtinTile(cells, lanes).raiseAll(map, all.back().data());
      EXPECT_EQ(all.back(), all.front()) << cells << " cells, " << lanes << " lanes";
    }
  }
}

TEST(TeRtinErrors, AreNothingOnPlanesAndAlwaysABound) {
  TeHeightMap plane = std::move(TeHeightMap::create(257, 257).value());
  for (int row = 0; row < 257; row++)
    for (int column = 0; column < 257; column++)
      plane.at(column, row) = float(3000 - 7 * column + 5 * row);
  for (const TeRtinError error : {TeRtinError::Exact, TeRtinError::Midpoint})
    for (const float found : TeRtinErrors::create(plane, error))
      ASSERT_EQ(found, 0);
  // A sample beside all middles of edges but the smallest: exact errors know it.
  plane.at(33, 77) += 100;
  const float whole = TeRtinErrors::create(plane, TeRtinError::Exact)[128 * 257 + 128];
  EXPECT_EQ(whole, 100);
}
