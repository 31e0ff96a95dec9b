// What terrane-accuracy measures with: surfaces of known error, known gaps and known jumps.

#include "apps/terrane-accuracy/TeLodSweep.h"
#include "apps/terrane-accuracy/TeMeshCheck.h"
#include "apps/terrane-accuracy/TePlot.h"
#include "apps/terrane-accuracy/TeTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using Mesh = std::vector<TeSeamlessMesh::Triangle>;

/// 17² samples, 10 m apart, all of height 100 units of half a metre.
TeMeasuredTerrain plain() {
  TeMeasuredTerrain terrain{"plain", TeHeightMap::create(17, 17).value(), 10, 0.5};
  EXPECT_TRUE(terrain.heights.fill(100, terrain.heights.bounds()));
  return terrain;
}

/// Two triangles a square of `step` cells over everything, at one height.
Mesh grid(int step, float height) {
  Mesh mesh;
  for (int row = 0; row < 16; row += step)
    for (int column = 0; column < 16; column += step) {
      const TeSeamlessMesh::Vertex a{column, row, height}, b{column + step, row, height};
      const TeSeamlessMesh::Vertex c{column + step, row + step, height}, d{column, row + step, height};
      mesh.push_back({a, b, c, false});
      mesh.push_back({a, c, d, false});
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
  TePlot plot{"it's \"x\"", "x [m]", "y",
              true,         true,    {{"one", {1, 0, 10, 100}, {2, 3, -1, 4}}, {"none", {}, {}}}};
  const std::string script = plot.script("svg", "/tmp/a'b.svg");
  EXPECT_NE(script.find("set output '/tmp/a''b.svg'"), std::string::npos) << script;
  EXPECT_NE(script.find("1 2\n100 4\nEND"), std::string::npos) << script;
  EXPECT_EQ(script.find("none"), std::string::npos) << script;
  EXPECT_EQ(TePlot().script("svg", "x"), "");
}

TEST(AccuracySurface, HasTheHeightsOfItsTriangles) {
  TeDrawnSurface surface(16);
  const TeSeamlessMesh::Vertex a{0, 0, 0}, b{8, 0, 8}, c{0, 16, 32};
  surface.draw({{a, b, c, false}});
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
  errors.addJump(terrain, everything(), before, after);
  EXPECT_NEAR(errors.popping(), 3.325, 1e-9);
}

TEST(AccuracyMeshCheck, CountsWhatIsNotShared) {
  const TeMeasuredTerrain terrain = plain();
  EXPECT_EQ(teCountCracks(grid(4, 100), terrain, everything()), 0);

  Mesh holed = grid(4, 100);
  holed.erase(holed.begin() + 10);
  EXPECT_EQ(teCountCracks(holed, terrain, everything()), 3);

  Mesh lifted = grid(4, 100);
  lifted[10].a.height = 101; // two of its edges no longer meet the neighbours'
  EXPECT_EQ(teCountCracks(lifted, terrain, everything()), 4);

  // A T-junction: one long edge, two short ones.
  const TeSeamlessMesh::Vertex a{0, 0, 100}, b{16, 0, 100}, c{16, 16, 100}, d{0, 16, 100}, middle{8, 8, 100};
  const Mesh junction = {{a, b, c, false}, {a, middle, d, false}, {middle, c, d, false}};
  EXPECT_EQ(teCountCracks(junction, terrain, everything()), 3);

  TeLodView blind = everything();
  blind.planes[0] = {0, 0, 1, -1000};
  blind.planeCount = 1;
  EXPECT_EQ(teCountCracks(junction, terrain, blind), 0) << "cracks out of view do not count";
}

} // namespace
