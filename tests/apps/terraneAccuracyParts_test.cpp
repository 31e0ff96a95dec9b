// What terrane-accuracy measures with: surfaces of known error, known gaps and known jumps.

#include "apps/terrane-accuracy/TeLodSweep.h"
#include "apps/terrane-accuracy/TePlot.h"
#include "apps/terrane-accuracy/TeTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

/// 17² samples, 10 m apart, all of height 100 units of half a metre.
TeMeasuredTerrain plain() {
  TeHeightMap heights = TeHeightMap::create(17, 17).value();
  EXPECT_TRUE(heights.fill(100, heights.bounds()));
  return TeMeasuredTerrain::create("plain", std::move(heights), 10, 0.5).value();
}

/// Two triangles a square of `step` cells over everything, at one height.
TeLodMesh grid(int step, float height) {
  TeLodMesh mesh;
  for (int row = 0; row < 16; row += step)
    for (int column = 0; column < 16; column += step) {
      const auto first = std::uint32_t(mesh.vertices.size());
      mesh.vertices.push_back({column, row, height});
      mesh.vertices.push_back({column + step, row, height});
      mesh.vertices.push_back({column + step, row + step, height});
      mesh.vertices.push_back({column, row + step, height});
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  return mesh;
}

/// From the south-west, 100 m above the ground, everything in view.
TeLodView everything() {
  TeLodView view;
  view.eye = {-100, 0, 50};
  view.focal = 665;
  return view;
}

TEST(AccuracyTable, WritesCsvJsonAndMarkdown) {
  TeTable table({"method", "wanted_px", "triangles", "bound_px"});
  table.addRow({std::string("a,\"b\""), 0.5, std::int64_t(12), std::numeric_limits<double>::infinity()});
  table.addRow({std::string("c"), {}, std::int64_t(7), 1.0 / 3});
  EXPECT_EQ(table.csv(), "method,wanted_px,triangles,bound_px\n\"a,\"\"b\"\"\",0.5,12,inf\nc,,7,0.333333\n");
  const auto json = nlohmann::json::parse(table.json().dump());
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["method"], "a,\"b\"");
  EXPECT_TRUE(json[0]["bound_px"].is_null());
  EXPECT_TRUE(json[1]["wanted_px"].is_null());
  EXPECT_EQ(json[1]["triangles"], 7);
  EXPECT_EQ(table.markdown().rfind("| method | wanted_px | triangles | bound_px |\n|---|---|---|---|\n", 0),
            0u);
  EXPECT_EQ(table.number(0, "triangles"), 12);
  EXPECT_TRUE(std::isnan(table.number(1, "wanted_px")));
}

TEST(AccuracySpread, MedianAndQuartiles) {
  const TeSpread spread = TeSpread::of({5, 1, 3, 2, 4});
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.low, 2);
  EXPECT_EQ(spread.high, 4);
  EXPECT_EQ(spread.mean, 3);
  EXPECT_EQ(TeSpread::of({1, 2}).median, 1.5);
  EXPECT_EQ(TeSpread::of({}).median, 0);
}

TEST(AccuracyPlot, LeavesOutWhatALogarithmCannotShow) {
  TePlot plot{"it's \"x\"",
              "x [m]",
              "y",
              true,
              true,
              {{"one", {1, 0, 10, 100}, {2, 3, -1, 4}}, {"none", {}, {}}},
              {}};
  const std::string script = plot.script("svg", "/tmp/a'b.svg");
  EXPECT_NE(script.find("set output '/tmp/a''b.svg'"), std::string::npos) << script;
  EXPECT_NE(script.find("1 2\n100 4\nEND"), std::string::npos) << script;
  EXPECT_EQ(script.find("none"), std::string::npos) << script;
  EXPECT_EQ(TePlot().script("svg", "x"), "");
}

TEST(AccuracySurface, HasTheHeightsOfItsTriangles) {
  TeDrawnSurface surface(16);
  surface.draw({{{0, 0, 0}, {8, 0, 8}, {0, 16, 32}}, {0, 1, 2}, {}});
  EXPECT_EQ(surface.height(0, 0), 0);
  EXPECT_EQ(surface.height(4, 0), 4);
  EXPECT_EQ(surface.height(4, 8), 20);
  EXPECT_EQ(surface.height(1, 3), 7);
  EXPECT_TRUE(std::isnan(surface.height(8, 1)));
  surface.draw({});
  EXPECT_TRUE(std::isnan(surface.height(0, 0)));
}

TEST(AccuracyErrors, TheWorstOfAllFramesAndTheMeanOfAllSamples) {
  TeScreenError::Report first;
  first.samples = 1010;
  first.uncovered = 10;
  first.worst = 4;
  first.quantile = 3;
  first.rms = 2;
  first.worstMetres = 7;
  TeScreenError::Report second;
  second.samples = 3000;
  second.worst = 5;
  second.quantile = 1;
  second.rms = 0;
  second.worstMetres = 6;
  TeMeasuredErrors errors;
  EXPECT_EQ(errors.rmsPixels(), 0);
  errors.add(first);
  errors.add(second);
  EXPECT_EQ(errors.worstPixels(), 5);
  EXPECT_EQ(errors.p999Pixels(), 3);
  EXPECT_EQ(errors.worstMetres(), 7);
  EXPECT_EQ(errors.uncovered(), 10);
  EXPECT_EQ(errors.samples(), 4000);
  EXPECT_NEAR(errors.rmsPixels(), 1, 1e-12);
}

TEST(AccuracyErrors, JumpsAreMeasuredBetweenFrames) {
  const TeMeasuredTerrain terrain = plain();
  TeDrawnSurface before(16), after(16);
  before.draw(grid(4, 101));
  after.draw(grid(8, 100));
  TeMeasuredErrors errors;
  errors.addJump(*terrain.field, everything(), before, after);
  EXPECT_NEAR(errors.popping(), 3.325, 1e-9);
}

TEST(AccuracyMethods, AreCalledByNameAndMorph) {
  const TeLodFieldPtr field = plain().field;
  EXPECT_EQ(TeLodCandidate::checkName("seamless"), "");
  EXPECT_EQ(TeLodCandidate::checkName("seamless-geomorph"), "");
  EXPECT_NE(TeLodCandidate::checkName("none"), "");
  EXPECT_NE(TeLodCandidate::checkName("-geomorph"), "");
  EXPECT_TRUE(TeLodCandidate::create("seamless-geomorph", "4/2", field)->geomorph());
  EXPECT_EQ(TeLodCandidate::create("brute", "4/2", field)->layout(), "");
  EXPECT_FALSE(TeLodCandidate::create("brute-geomorph", "4/2", field));
  EXPECT_FALSE(TeLodCandidate::create("seamless", "3/2", field));
}

TEST(AccuracyMethods, OnlyNewPartsAreSent) {
  TeLodCandidate brute = TeLodCandidate::create("brute", "", plain().field).value();
  brute.select(everything(), TeLodAccuracy());
  EXPECT_EQ(brute.uploadBytes({}), 17 * 17 * 12 + 2 * 16 * 16 * 3 * 4);
  EXPECT_EQ(brute.uploadBytes({brute.selection().parts[0].key}), 0);
}

} // namespace
