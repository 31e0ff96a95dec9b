#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "nodes/badFields.h"
#include "nodes/fileFormat.h"
#include "nodes/rawFile.h"
#include "nodes/seamless/TeSeamlessBoundsFile.h"
#include "nodes/seamless/hillsNode.h"
#include "nodes/writtenScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace {

struct Point {
  float x, y, z;
  bool operator<(const Point& other) const { return std::tie(x, y, z) < std::tie(other.x, other.y, other.z); }
};

/// Edges that are not shared by two triangles.
int openEdges(const std::vector<EmittedTriangle>& mesh) {
  std::map<std::pair<Point, Point>, int> edges;
  for (const EmittedTriangle& t : mesh) {
    for (int i = 0; i < 3; i++) {
      const SbVec3f &a = t[std::size_t(i)], &b = t[std::size_t((i + 1) % 3)];
      const Point from{a[0], a[1], a[2]}, to{b[0], b[1], b[2]};
      edges[from < to ? std::pair(from, to) : std::pair(to, from)]++;
    }
  }
  int open = 0;
  for (const auto& [edge, count] : edges)
    open += count != 2;
  return open;
}

} // namespace

TEST(SoTeSeamlessPatches, DefaultsAreThoseOfTheDocument) {
  const auto root = readScene("TeSeamlessPatches {}");
  ASSERT_TRUE(root);
  SoTeSeamlessPatches* terrain = firstOf<SoTeSeamlessPatches>(root.get());
  ASSERT_TRUE(terrain);
  EXPECT_EQ(terrain->size.getValue(), SbVec3f(256, 256, 10));
  EXPECT_EQ(terrain->resolution.getValue(), 4096);
  EXPECT_EQ(terrain->minPatchResolution.getValue(), 16);
  EXPECT_EQ(terrain->levels.getValue(), 3);
  EXPECT_EQ(terrain->precision.getValue(), 2);
  EXPECT_TRUE(terrain->instancing.getValue());
  EXPECT_TRUE(terrain->wholePatches.getValue());
  EXPECT_EQ(terrain->getError(), "");
  EXPECT_GT(triangles(root.get()), 1000);
  EXPECT_EQ(boxOf(root.get()), SbBox3f(-128, -128, 0, 128, 128, 0));
}

// Without a camera everything is there: the mesh has no open edge but its rim, and covers the square.
TEST(SoTeSeamlessPatches, EmittedMeshIsWholeAndClosed) {
  const auto node = hillsNode();
  for (const bool geomorph : {false, true}) {
    node->geomorph = geomorph;
    for (const float precision : {1.0f, 3.0f, 9.5f}) {
      node->precision = precision;
      const std::vector<EmittedTriangle> mesh = emitted(node.get());
      EXPECT_EQ(int(mesh.size()), triangles(node.get()));
      EXPECT_NEAR(areaFromAbove(mesh), 1e6, 1);
      const SbBox3f box = boxOf(node.get());
      int rim = 0;
      for (const EmittedTriangle& t : mesh) {
        for (int i = 0; i < 3; i++) {
          EXPECT_TRUE(box.intersect(t[std::size_t(i)]));
          const SbVec3f &a = t[std::size_t(i)], &b = t[std::size_t((i + 1) % 3)];
          for (int axis = 0; axis < 2; axis++)
            rim += a[axis] == b[axis] && std::abs(a[axis]) == 500;
        }
      }
      EXPECT_EQ(openEdges(mesh), rim);
    }
  }
}

TEST(SoTeSeamlessPatches, MorePrecisionAndLessErrorAreMoreTriangles) {
  const auto node = hillsNode(1024);
  const auto root = seenBy(SbVec3f(0, -480, 160), SbVec3f(0, 0, 100), node.get());
  int before = 0;
  for (const float precision : {1.0f, 2.0f, 4.0f, 8.0f}) {
    node->precision = precision;
    EXPECT_GT(triangles(root.get()), before);
    before = triangles(root.get());
  }
  before = 0;
  for (const float error : {20.0f, 5.0f, 1.0f}) {
    node->pixelError = error;
    EXPECT_GT(triangles(root.get()), before);
    before = triangles(root.get());
  }
}

TEST(SoTeSeamlessPatches, ComplexityIsTheDialOfPrecision) {
  const auto root =
      readScene("DEF TestComplexity Complexity {} DEF TestTerrain TeSeamlessPatches { precision 4 }");
  ASSERT_TRUE(root);
  SoField* value = SoNode::getByName("TestComplexity")->getField("value");
  const int plain = triangles(SoNode::getByName("TestTerrain"));
  EXPECT_EQ(triangles(root.get()), plain); // 0.5
  value->set("0.75");                      // twice as accurate
  auto* terrain = static_cast<SoTeSeamlessPatches*>(SoNode::getByName("TestTerrain"));
  const int fine = triangles(root.get());
  terrain->precision = 8;
  EXPECT_EQ(triangles(terrain), fine);
  value->set("0");
  terrain->precision = 1;
  EXPECT_EQ(triangles(root.get()), triangles(terrain)); // not below 1
}

TEST(SoTeSeamlessPatches, BudgetOfPatchesHolds) {
  const auto node = hillsNode();
  node->precision = 50;
  const int all = triangles(node.get());
  node->maxPatches = 5;
  EXPECT_LT(triangles(node.get()), all);
  EXPECT_GT(triangles(node.get()), 0);
}

TEST(SoTeSeamlessPatches, MoreTrianglesThanCoinCountsAreAsManyAsItCounts) {
  const auto root =
      readScene("TeSeamlessPatches { resolution 131072 minPatchResolution 256 levels 2 precision 1000000 "
                "maxPatches 100000 }");
  EXPECT_EQ(triangles(root.get()), std::numeric_limits<int>::max());
}

TEST(SoTeSeamlessPatches, HeaderTellsFieldsAndDefaults) {
  EXPECT_EQ(fieldsOf(TeNodePtr<SoTeSeamlessPatches>(new SoTeSeamlessPatches).get()),
            fileFormat("nodes/seamless/SoTeSeamlessPatches.h"));
}

TEST(SoTeSeamlessPatches, FieldsSurviveWritingAndReading) {
  const auto root = readScene(
      "TeSeamlessPatches { size 5000 5000 300 resolution 1024 minPatchResolution 8 levels 4 precision 3.5 "
      "pixelError 1.25 maxPatches 77 geomorph TRUE instancing FALSE wholePatches FALSE wireframe TRUE "
      "heightSource HEIGHTMAP "
      "heightFile \"a.raw\" verticalUnit \"0.1\" heights TeClipmap { name \"b\" } coloring HEIGHT "
      "tileColor 1 0 1 stripColor 0 1 0 texture \"t.png\" colors TeClipmap { kind COLOR } mask \"m.png\" "
      "detailTextures [ \"1\", \"2\", \"3\", \"4\" ] detailRepeat 9 groundColors [ 0 0 1, 0 1 0 ] "
      "groundHeights [ 1, 2, 3, 4 ] groundSlopes [ 1, 1, 1, 1, 2 ] lodCamera PerspectiveCamera {} "
      "center 12345678.125 -7.5 1 origin 12345678 0 2 }");
  ASSERT_TRUE(root);
  const auto again = readAgain(root.get());
  const SoTeSeamlessPatches* b = firstOf<SoTeSeamlessPatches>(again.get());
  ASSERT_TRUE(b);
  EXPECT_EQ(b->center.getValue(), SbVec3d(12345678.125, -7.5, 1));
  EXPECT_EQ(b->levels.getValue(), 4);
  EXPECT_EQ(b->detailTextures.getNum(), 4);
  EXPECT_TRUE(b->lodCamera.getValue() && b->heights.getValue() && b->colors.getValue());
}

TEST(SoTeSeamlessPatches, BadFieldsGiveOneWarningAndNothing) {
  const std::string folder = testing::TempDir();
  writeRaw(folder + "good.raw", 33, 2);
  writeRaw(folder + "short.raw", 33, 1);
  writeRaw(folder + "even.raw", 32, 2);
  const std::string map = "resolution 0 heightSource HEIGHTMAP heightFile \"" + folder + "good.raw\" ";
  {
    const CoinWarnings warnings;
    EXPECT_GT(triangles(readScene("TeSeamlessPatches { " + map + "}").get()), 0);
    EXPECT_THAT(warnings.lines, testing::IsEmpty());
  }
  for (const std::string& fields : std::vector<std::string>{
           "size 256 128 10",
           "size -1 -1 10",
           "size 256 256 -10",
           "size 1e12 1e12 10",
           "resolution 4095",
           "resolution 0",
           "resolution -4096",
           "resolution 2147483647",
           "minPatchResolution 0",
           "minPatchResolution 15",
           "minPatchResolution 8192",
           "levels 1",
           "levels 0",
           "levels 100",
           "precision 0",
           "precision -2",
           "precision 0.5",
           "pixelError -1",
           "maxPatches 0",
           "maxPatches -5",
           "maxPatches 2147483647",
           "heightSource HEIGHTMAP",
           "heightSource HEIGHTMAP heightFile \"/nonexistent.raw\"",
           "heightSource HEIGHTMAP heightFile \"/dev/null\"",
           "heightSource HEIGHTMAP heightFile \"" + folder + "short.raw\"",
           "heightSource HEIGHTMAP heightFile \"" + folder + "even.raw\"",
           "heightSource HEIGHTMAP heightFile \"" + folder + "good.raw\"", // not 4096
           map + "verticalUnit \"furlongs\"",
           "heightSource CLIPMAPS",
           "heightSource CLIPMAPS heights Cube {}",
           "heightSource CLIPMAPS heights TeClipmap { name \"/nonexistent\" }",
           "lodCamera Cube {}",
           "coloring TEXTURE",
           "coloring TEXTURE texture \"/nonexistent.png\"",
           "coloring TEXTURE colors Cube {}",
           "coloring DETAIL",
           "coloring DETAIL mask \"/nonexistent.png\" detailTextures [ \"a\", \"b\", \"c\", \"d\" ]",
           "coloring HEIGHT groundHeights [ 1 ]",
           "coloring HEIGHT groundSlopes [ 1 ]"})
    expectOneWarningAndNothing<SoTeSeamlessPatches>("TeSeamlessPatches { " + fields + " }");
}

TEST(SoTeSeamlessPatches, NumbersThatNameNothingAreErrors) {
  const CoinWarnings warnings;
  const auto node = hillsNode();
  for (const int coloring : {-1, 4, 1 << 30}) {
    node->coloring = coloring;
    EXPECT_EQ(triangles(node.get()), 0);
    EXPECT_THAT(node->getError(), testing::HasSubstr("coloring " + std::to_string(coloring)));
  }
  node->coloring = SoTeSeamlessPatches::HEIGHT;
  node->heightSource = 3;
  EXPECT_THAT(node->getError(), testing::HasSubstr("heightSource 3"));
  node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  EXPECT_GT(triangles(node.get()), 0);
  node->precision = std::nanf("");
  expectOneWarningAndNothing(node.get(), "precision");
}

TEST(SoTeSeamlessPatches, RawNumbersAreScaledByTheSize) {
  const std::string path = testing::TempDir() + "scaled.raw";
  writeRaw(path, 33, 2); // 0 .. 32·256 + 32, rows from the north
  const std::string file = "resolution 32 heightSource HEIGHTMAP heightFile \"" + path + "\" ";
  const auto scaled = readScene("TeSeamlessPatches { " + file + "size 64 64 655.35 }");
  EXPECT_NEAR(boxOf(scaled.get()).getMax()[2], 82.24f, 1e-3f);
  const auto metres = readScene("TeSeamlessPatches { " + file + "size 64 64 1 verticalUnit \"dm\" }");
  EXPECT_NEAR(boxOf(metres.get()).getMax()[2], 822.4f, 1e-2f);
  SoRayPickAction pick(kViewport);
  // The file's first sample is in the north-west.
  const SoPickedPoint* point = pickDown(pick, scaled.get(), -31.9f, 31.9f);
  ASSERT_TRUE(point);
  EXPECT_LT(point->getPoint()[2], 1);
}

// Clipmaps that hold everything give the same heights as a height map; windows that are small cover what
// they can, without a gap.
TEST(SoTeSeamlessPatches, ClipmapsEmitTheSameHills) {
  const HillsPyramid pyramid(512);
  const auto whole = pyramid.node(513);
  const auto map = hillsNode(512);
  map->setHeights(std::make_shared<const TeHeightMap>(hillsMap(512, 100)));
  map->size.setValue(1000, 1000, 0);
  EXPECT_EQ(triangles(whole.get()), triangles(map.get()));
  std::map<std::pair<float, float>, float> heights;
  for (const EmittedTriangle& t : emitted(map.get())) {
    for (const SbVec3f& corner : t)
      heights[{corner[0], corner[1]}] = corner[2];
  }
  const std::vector<EmittedTriangle> mesh = emitted(whole.get());
  EXPECT_GT(mesh.size(), 1000u);
  for (const EmittedTriangle& t : mesh) {
    for (const SbVec3f& corner : t) {
      const auto found = heights.find({corner[0], corner[1]});
      ASSERT_NE(found, heights.end());
      EXPECT_NEAR(corner[2], found->second / 100, 1e-4f);
    }
  }
  const auto windows = pyramid.node(65);
  for (const SbVec3f& eye : {SbVec3f(0, 0, 160), SbVec3f(-480, 300, 130), SbVec3f(600, 900, 200)}) {
    windows->precision = 8;
    const std::vector<EmittedTriangle> limited =
        emitted(seenBy(eye, SbVec3f(20, 10, 60), windows.get()).get());
    EXPECT_GT(limited.size(), 0u);
  }
  EXPECT_NEAR(areaFromAbove(emitted(windows.get())), 1e6, 1);
}

TEST(SoTeSeamlessPatches, PixelErrorOfClipmapsNeedsTheirErrors) {
  const HillsPyramid pyramid(256);
  const auto node = pyramid.node(129);
  EXPECT_EQ(node->getError(), "");
  {
    const CoinWarnings warnings;
    node->pixelError = 2;
    EXPECT_THAT(node->getError(), testing::HasSubstr("terrane-bake"));
    EXPECT_THAT(node->getError(), testing::HasSubstr("_bounds_16_3.bin"));
    EXPECT_EQ(triangles(node.get()), 0);
    EXPECT_EQ(warnings.lines.size(), 1u);
  }
  const auto layout = TeSeamlessLayout::create(256, 16, 3);
  const auto bounds = TeSeamlessBounds::create(*layout, pyramid.map());
  ASSERT_TRUE(bounds);
  ASSERT_TRUE(TeSeamlessBoundsFile::save(**bounds, TeSeamlessBoundsFile::nameFor(pyramid.name(), *layout)));
  node->heights.touch(); // looks again
  EXPECT_EQ(node->getError(), "");
  EXPECT_GT(triangles(node.get()), 0);
  EXPECT_LT(boxOf(node.get()).getMax()[2], 146); // and knows how high the ground is
}
