#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "generators/TeHeightMap.h"
#include "nodes/TeNodePtr.h"
#include "nodes/TeSceneFile.h"
#include "nodes/coinWarnings.h"
#include "nodes/readScene.h"
#include "nodes/seamless/TeSeamlessBoundsFile.h"
#include "nodes/seamless/hillsNode.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>

namespace {

const SbViewportRegion kViewport(640, 480);

int triangles(SoNode* root) {
  SoGetPrimitiveCountAction count(kViewport);
  count.apply(root);
  return count.getTriangleCount();
}

SbBox3f boxOf(SoNode* root) {
  SoGetBoundingBoxAction bounds(kViewport);
  bounds.apply(root);
  return bounds.getBoundingBox();
}

SoTeSeamlessPatches* terrainOf(SoNode* root) {
  SoSearchAction search;
  search.setType(SoTeSeamlessPatches::getClassTypeId());
  search.apply(root);
  return search.getPath() ? static_cast<SoTeSeamlessPatches*>(search.getPath()->getTail()) : nullptr;
}

struct Point {
  float x, y, z;
  bool operator<(const Point& other) const { return std::tie(x, y, z) < std::tie(other.x, other.y, other.z); }
};

struct Emitted {
  std::vector<std::array<SbVec3f, 3>> triangles;
};

/// What SoCallbackAction gets.
Emitted emitted(SoNode* root) {
  Emitted result;
  SoCallbackAction action(kViewport);
  action.addTriangleCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        static_cast<Emitted*>(data)->triangles.push_back({a->getPoint(), b->getPoint(), c->getPoint()});
      },
      &result);
  action.apply(root);
  return result;
}

double areaFromAbove(const Emitted& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (double(t[1][0] - t[0][0]) * double(t[2][1] - t[0][1]) -
                   double(t[2][0] - t[0][0]) * double(t[1][1] - t[0][1]));
  return area;
}

/// Edges that are not shared by two triangles.
int openEdges(const Emitted& mesh) {
  std::map<std::pair<Point, Point>, int> edges;
  for (const auto& t : mesh.triangles) {
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

std::string written(SoNode* root) {
  const std::string path = testing::TempDir() + "seamless-written.iv";
  EXPECT_TRUE(teWriteScene(root, path));
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(path);
  return text;
}

void writeRaw(const std::string& path, int side, int bytes) {
  std::ofstream file(path, std::ios::binary);
  for (int row = 0; row < side; row++) {
    for (int column = 0; column < side; column++) {
      const int value = row * 256 + column;
      file.put(char(value & 255));
      if (bytes == 2)
        file.put(char(value >> 8));
    }
  }
}

} // namespace

TEST(SoTeSeamlessPatches, DefaultsAreThoseOfTheDocument) {
  const auto root = readScene("TeSeamlessPatches {}");
  ASSERT_TRUE(root);
  SoTeSeamlessPatches* terrain = terrainOf(root.get());
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
      const Emitted mesh = emitted(node.get());
      EXPECT_EQ(int(mesh.triangles.size()), triangles(node.get()));
      EXPECT_NEAR(areaFromAbove(mesh), 1e6, 1);
      const SbBox3f box = boxOf(node.get());
      int rim = 0;
      for (const auto& t : mesh.triangles) {
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

TEST(SoTeSeamlessPatches, CameraDecidesWhatThereIs) {
  const auto node = hillsNode();
  const auto near = seenBy(SbVec3f(-400, -400, 200), SbVec3f(0, 0, 100), node.get());
  const auto away = seenBy(SbVec3f(-400, -400, 200), SbVec3f(-900, -900, 100), node.get());
  EXPECT_GT(triangles(near.get()), 1000);
  EXPECT_LT(triangles(away.get()), triangles(near.get()) / 4);
  EXPECT_EQ(int(emitted(near.get()).triangles.size()), triangles(near.get()));
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

TEST(SoTeSeamlessPatches, ComplexityIsTheAccuracysDial) {
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

TEST(SoTeSeamlessPatches, RaysMeetWhatIsDrawn) {
  const auto node = hillsNode();
  const auto root = seenBy(SbVec3f(-450, -450, 250), SbVec3f(0, 0, 100), node.get());
  const Emitted mesh = emitted(root.get());
  std::mt19937 numbers(3);
  SoRayPickAction pick(kViewport);
  int hits = 0;
  for (int i = 0; i < 60; i++) {
    // Into the middle of a triangle, somewhat aslant.
    const auto& t = mesh.triangles[numbers() % mesh.triangles.size()];
    const SbVec3f middle = (t[0] + t[1] + t[2]) / 3;
    const SbVec3f from = middle + SbVec3f(3, -4, 400);
    pick.setRay(from, middle - from);
    pick.apply(root.get());
    const SoPickedPoint* point = pick.getPickedPoint();
    ASSERT_TRUE(point);
    EXPECT_LT((point->getPoint() - middle).length(), 1e-2f);
    const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(node.get()));
    ASSERT_TRUE(detail);
    EXPECT_NEAR(detail->getHeight(), double(middle[2]), 1e-2);
    EXPECT_GT(detail->getNormal().z, 0);
    hits++;
  }
  EXPECT_EQ(hits, 60);
  // Behind the camera nothing is drawn, but rays meet the ground.
  pick.setRay(SbVec3f(-490, -490, 1000), SbVec3f(0, 0, -1));
  pick.apply(root.get());
  EXPECT_TRUE(pick.getPickedPoint());
  pick.setRay(SbVec3f(-510, -490, 1000), SbVec3f(0, 0, -1));
  pick.apply(root.get());
  EXPECT_FALSE(pick.getPickedPoint());
}

TEST(SoTeSeamlessPatches, AllHitsAlongARay) {
  const auto node = hillsNode();
  SoRayPickAction pick(kViewport);
  pick.setPickAll(TRUE);
  pick.setRay(SbVec3f(-600, 20, 100), SbVec3f(1, 0.01f, 0));
  pick.apply(node.get());
  EXPECT_GT(pick.getPickedPointList().getLength(), 3);
  const auto root = readScene("PickStyle { style UNPICKABLE }");
  root->addChild(node.get());
  pick.apply(root.get());
  EXPECT_EQ(pick.getPickedPointList().getLength(), 0);
}

TEST(SoTeSeamlessPatches, LiesWhereCenterAndOriginSay) {
  const auto node = hillsNode();
  node->center.setValue(1e8 + 100, -3e8, 50);
  node->origin.setValue(1e8, -3e8, 0);
  const SbBox3f box = boxOf(node.get());
  EXPECT_EQ(box.getMin()[0], -400);
  EXPECT_EQ(box.getMax()[1], 500);
  SoRayPickAction pick(kViewport);
  pick.setRay(SbVec3f(130, 40, 1000), SbVec3f(0, 0, -1));
  pick.apply(node.get());
  const SoPickedPoint* point = pick.getPickedPoint();
  ASSERT_TRUE(point);
  const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(node.get()));
  ASSERT_TRUE(detail);
  EXPECT_NEAR(detail->getPosition().x, 1e8 + 130, 1e-3);
  EXPECT_NEAR(detail->getPosition().y, -3e8 + 40, 1e-3);
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
  const std::string text = written(root.get());
  SoInput input;
  input.setBuffer(text.data(), text.size());
  TeNodePtr<SoSeparator> again(SoDB::readAll(&input));
  ASSERT_TRUE(again);
  EXPECT_EQ(written(again.get()), text);
  const SoTeSeamlessPatches* b = terrainOf(again.get());
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
           "coloring HEIGHT groundSlopes [ 1 ]"}) {
    const CoinWarnings warnings;
    const auto root = readScene("TeSeamlessPatches { " + fields + " }");
    ASSERT_TRUE(root) << fields;
    EXPECT_EQ(triangles(root.get()), 0) << fields;
    EXPECT_EQ(emitted(root.get()).triangles.size(), 0u) << fields;
    EXPECT_TRUE(boxOf(root.get()).isEmpty()) << fields;
    EXPECT_EQ(warnings.lines.size(), 1u) << fields << ": " << testing::PrintToString(warnings.lines);
    EXPECT_FALSE(terrainOf(root.get())->getError().empty()) << fields;
  }
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
}

TEST(SoTeSeamlessPatches, NotANumberIsOneWarning) {
  const float nan = std::nanf("");
  const auto node = hillsNode();
  const auto expectNothing = [&](const char* field) {
    const CoinWarnings warnings;
    EXPECT_EQ(triangles(node.get()), 0) << field;
    EXPECT_EQ(triangles(node.get()), 0) << field;
    EXPECT_EQ(warnings.lines.size(), 1u) << field;
  };
  node->precision = nan;
  expectNothing("precision");
  node->precision = 2;
  node->pixelError = nan;
  expectNothing("pixelError");
  node->pixelError = 0;
  node->size.setValue(nan, nan, 1);
  expectNothing("size");
  node->size.setValue(1000, 1000, 0);
  node->center.setValue(0, double(nan), 0);
  expectNothing("center");
  node->center.setValue(0, 0, 0);
  const CoinWarnings warnings;
  EXPECT_GT(triangles(node.get()), 0); // good again
  EXPECT_THAT(warnings.lines, testing::IsEmpty());
  EXPECT_EQ(node->getError(), "");
}

TEST(SoTeSeamlessPatches, MissingSamplesAreAnError) {
  TeHeightMap map = hillsMap(64);
  map.at(7, 9) = TeHeightMap::missing();
  TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
  node->resolution = 64;
  node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  const CoinWarnings warnings;
  node->setHeights(std::make_shared<const TeHeightMap>(map));
  EXPECT_THAT(node->getError(), testing::HasSubstr("missing"));
  EXPECT_EQ(triangles(node.get()), 0);
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
  pick.setRay(SbVec3f(-31.9f, 31.9f, 5000),
              SbVec3f(0, 0, -1)); // the file's first sample is in the north-west
  pick.apply(scaled.get());
  ASSERT_TRUE(pick.getPickedPoint());
  EXPECT_LT(pick.getPickedPoint()->getPoint()[2], 1);
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
  for (const auto& t : emitted(map.get()).triangles) {
    for (const SbVec3f& corner : t)
      heights[{corner[0], corner[1]}] = corner[2];
  }
  const Emitted mesh = emitted(whole.get());
  EXPECT_GT(mesh.triangles.size(), 1000u);
  for (const auto& t : mesh.triangles) {
    for (const SbVec3f& corner : t) {
      const auto found = heights.find({corner[0], corner[1]});
      ASSERT_NE(found, heights.end());
      EXPECT_NEAR(corner[2], found->second / 100, 1e-4f);
    }
  }
  const auto windows = pyramid.node(65);
  for (const SbVec3f& eye : {SbVec3f(0, 0, 160), SbVec3f(-480, 300, 130), SbVec3f(600, 900, 200)}) {
    windows->precision = 8;
    const Emitted limited = emitted(seenBy(eye, SbVec3f(20, 10, 60), windows.get()).get());
    EXPECT_GT(limited.triangles.size(), 0u);
  }
  const Emitted all = emitted(windows.get());
  EXPECT_NEAR(areaFromAbove(all), 1e6, 1);
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

TEST(SoTeSeamlessPatches, ChangesNotifyAndUseDoesNot) {
  const auto node = hillsNode();
  TeNodePtr<SoSeparator> root(new SoSeparator);
  root->addChild(node.get());
  int changes = 0;
  SoNodeSensor sensor([](void* data, SoSensor*) { ++*static_cast<int*>(data); }, &changes);
  sensor.setPriority(0);
  sensor.attach(root.get());
  triangles(root.get());
  emitted(root.get());
  boxOf(root.get());
  EXPECT_EQ(changes, 0);
  node->precision = 5;
  EXPECT_EQ(changes, 1);
  const int before = triangles(root.get());
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(128)));
  EXPECT_EQ(changes, 2);
  EXPECT_NE(triangles(root.get()), before);
}

TEST(SoTeSeamlessPatches, CopiesAreOfTheirOwn) {
  const auto node = hillsNode();
  const int before = triangles(node.get());
  TeNodePtr<SoTeSeamlessPatches> copy(static_cast<SoTeSeamlessPatches*>(node->copy()));
  EXPECT_EQ(triangles(copy.get()), before); // heights set in C++ go with it
  copy->precision = 9;
  EXPECT_GT(triangles(copy.get()), before);
  EXPECT_EQ(triangles(node.get()), before);
}

TEST(SoTeSeamlessPatches, AnotherCameraMayDecide) {
  const auto node = hillsNode();
  TeNodePtr<SoPerspectiveCamera> far(new SoPerspectiveCamera);
  far->position.setValue(0, 0, 5000);
  far->farDistance = 10000;
  const auto root = seenBy(SbVec3f(-400, -400, 200), SbVec3f(0, 0, 100), node.get());
  const int near = triangles(root.get());
  node->lodCamera = far.get();
  EXPECT_LT(triangles(root.get()), near);
  far->position.setValue(0, 0, 150);
  const int close = triangles(root.get());
  EXPECT_GT(close, 500);
  node->lodCamera = nullptr;
  EXPECT_EQ(triangles(root.get()), near);
}
