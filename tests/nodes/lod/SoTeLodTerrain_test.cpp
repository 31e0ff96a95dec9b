#include "nodes/lod/SoTeLodTerrain.h"

#include "nodes/TeSceneFile.h"
#include "nodes/coinWarnings.h"
#include "nodes/lod/TeCameraView.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/lodNode.h"
#include "nodes/readScene.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoComplexity.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
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

SoTeLodTerrain* terrainOf(SoNode* root) {
  SoSearchAction search;
  search.setType(SoTeLodTerrain::getClassTypeId());
  search.apply(root);
  return search.getPath() ? static_cast<SoTeLodTerrain*>(search.getPath()->getTail()) : nullptr;
}

using Triangle = std::array<SbVec3f, 3>;

/// What SoCallbackAction gets.
std::vector<Triangle> emitted(SoNode* root) {
  std::vector<Triangle> result;
  SoCallbackAction action(kViewport);
  action.addTriangleCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        static_cast<std::vector<Triangle>*>(data)->push_back({a->getPoint(), b->getPoint(), c->getPoint()});
      },
      &result);
  action.apply(root);
  return result;
}

double areaFromAbove(const std::vector<Triangle>& mesh) {
  double area = 0;
  for (const Triangle& t : mesh)
    area += 0.5 * (double(t[1][0] - t[0][0]) * double(t[2][1] - t[0][1]) -
                   double(t[2][0] - t[0][0]) * double(t[1][1] - t[0][1]));
  return area;
}

std::string written(SoNode* root) {
  const std::string path = testing::TempDir() + "lod-written.iv";
  EXPECT_TRUE(teWriteScene(root, path));
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(path);
  return text;
}

void writeRaw(const std::string& path, int side, int bytes = 2) {
  std::ofstream file(path, std::ios::binary);
  for (int i = 0; i < side * side; i++)
    file << std::string(std::size_t(bytes), char(i % 7));
}

/// What every method must do.
class EveryMethod : public testing::TestWithParam<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodTerrain, EveryMethod, testing::ValuesIn(TeLodMethods::names()),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& letter : name)
                             letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
                           return name;
                         });

// Without a camera everything is there.
TEST_P(EveryMethod, CoversTheWholeSquare) {
  const auto node = lodNode(GetParam());
  for (const float error : {8.0f, 0.5f}) {
    node->pixelError = error;
    const std::vector<Triangle> mesh = emitted(node.get());
    EXPECT_EQ(int(mesh.size()), triangles(node.get()));
    EXPECT_NEAR(areaFromAbove(mesh), 1e6, 1);
  }
  EXPECT_EQ(boxOf(node.get()).getMin()[0], -500);
  EXPECT_EQ(boxOf(node.get()).getMax()[1], 500);
}

TEST_P(EveryMethod, CameraDecidesWhatThereIs) {
  const auto node = lodNode(GetParam());
  const auto near = seenBy(SbVec3f(-400, -400, 200), SbVec3f(0, 0, 100), node.get());
  const auto away = seenBy(SbVec3f(-400, -400, 200), SbVec3f(-900, -900, 100), node.get());
  EXPECT_GT(triangles(near.get()), 300);
  EXPECT_LT(triangles(away.get()), triangles(near.get()));
}

TEST_P(EveryMethod, RaysMeetWhatIsDrawn) {
  const auto node = lodNode(GetParam());
  const auto root = seenBy(SbVec3f(-450, -450, 250), SbVec3f(0, 0, 100), node.get());
  std::vector<Triangle> mesh = emitted(root.get());
  std::mt19937 numbers(3);
  SoRayPickAction pick(kViewport);
  for (int i = 0; i < 40;) {
    const Triangle& t = mesh[numbers() % mesh.size()];
    if ((t[1] - t[0]).cross(t[2] - t[0])[2] <= 0)
      continue; // a skirt
    i++;
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
    EXPECT_EQ(detail->getPatchKey().x, std::int64_t(std::floor((double(middle[0]) + 500) / 7.8125)));
  }
  // Behind the camera nothing is drawn, but rays meet the surface of all samples.
  const auto behind = seenBy(SbVec3f(0, 0, 250), SbVec3f(0, 500, 100), node.get());
  const TeHeightMap map = hillsMap(128);
  for (int column = 5; column < 128; column += 31) {
    const float x = float(column) * 7.8125f - 500, y = 10 * 7.8125f - 500;
    pick.setRay(SbVec3f(x, y, 1000), SbVec3f(0, 0, -1));
    pick.apply(behind.get());
    ASSERT_TRUE(pick.getPickedPoint()) << column;
    EXPECT_NEAR(pick.getPickedPoint()->getPoint()[2], map.at(column, 10), 1e-2f);
  }
  pick.setRay(SbVec3f(-510, -490, 1000), SbVec3f(0, 0, -1));
  pick.apply(behind.get());
  EXPECT_FALSE(pick.getPickedPoint());
}

TEST_P(EveryMethod, BoundingBoxHoldsEverything) {
  const auto node = lodNode(GetParam());
  const SbBox3f box = boxOf(node.get());
  int outside = 0;
  for (const Triangle& t : emitted(node.get()))
    for (const SbVec3f& corner : t) // skirts may be lower
      outside += corner[0] < box.getMin()[0] || corner[0] > box.getMax()[0] || corner[1] < box.getMin()[1] ||
                 corner[1] > box.getMax()[1] || corner[2] > box.getMax()[2];
  EXPECT_EQ(outside, 0);
}

TEST(SoTeLodTerrain, ComplexityIsTheAccuracysDial) {
  const auto node = lodNode("seamless", 512);
  TeNodePtr<SoSeparator> root = seenBy(SbVec3f(0, -480, 160), SbVec3f(0, 0, 100), node.get());
  auto* complexity = new SoComplexity;
  root->insertChild(complexity, 1);
  node->pixelError = 4;
  const int plain = triangles(root.get());
  complexity->value = 0.75f; // twice as accurate
  const int finer = triangles(root.get());
  EXPECT_GT(finer, plain);
  complexity->value = 0.5f;
  EXPECT_EQ(triangles(root.get()), plain);
  node->pixelError = 2;
  EXPECT_EQ(triangles(root.get()), finer);
  node->dial = 3;
  const int three = triangles(root.get());
  node->dial = 1.5f;
  complexity->value = 0.75f;
  EXPECT_EQ(triangles(root.get()), three);
}

TEST(SoTeLodTerrain, BudgetOfTrianglesHolds) {
  const auto node = lodNode("seamless", 512);
  node->pixelError = 0;
  EXPECT_GT(triangles(node.get()), 200000);
  node->maxTriangles = 5000;
  EXPECT_LE(triangles(node.get()), 5000);
  EXPECT_GT(triangles(node.get()), 0);
}

TEST(SoTeLodTerrain, AllHitsAlongARay) {
  const auto node = lodNode("brute");
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

TEST(SoTeLodTerrain, LiesWhereCenterAndOriginSay) {
  const auto node = lodNode("seamless");
  const int there = triangles(node.get());
  node->center.setValue(1e8 + 100, -3e8, 50);
  node->origin.setValue(1e8, -3e8, 0);
  EXPECT_EQ(boxOf(node.get()).getMin()[0], -400);
  EXPECT_EQ(boxOf(node.get()).getMax()[1], 500);
  EXPECT_EQ(triangles(node.get()), there);
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

TEST(SoTeLodTerrain, AFieldLiesWhereItSays) {
  TeLodField::Placement placement;
  placement.corner = {5000, 200, -30};
  placement.spacing = 3;
  placement.heightScale = 0.5;
  const TeNodePtr<SoTeLodTerrain> node(new SoTeLodTerrain);
  node->setField(*TeLodField::create(std::make_shared<const TeHeightMap>(hillsMap(64)), placement));
  node->center.setValue(7, 7, 7); // has no part in it
  node->origin.setValue(4900, 0, 0);
  EXPECT_EQ(node->getError(), "");
  const SbBox3f box = boxOf(node.get());
  EXPECT_EQ(box.getMin()[0], 100);
  EXPECT_EQ(box.getMax()[1], 200 + 64 * 3);
  EXPECT_LT(box.getMax()[2], 145.0f / 2 - 30);
  EXPECT_GT(triangles(node.get()), 0);
}

TEST(SoTeLodTerrain, FieldsSurviveWritingAndReading) {
  const auto root = readScene(
      "TeLodTerrain { method \"brute\" heightFile \"a.raw\" verticalUnit \"0.1\" size 5000 5000 300 "
      "pixelError 1.25 dial 7.5 geomorph TRUE maxTriangles 77 slice 0.0025 submission DISPLAY_LISTS "
      "wireframe TRUE coloring HEIGHT lodCamera PerspectiveCamera {} center 12345678.125 -7.5 1 "
      "origin 12345678 0 2 }");
  ASSERT_TRUE(root);
  const std::string text = written(root.get());
  SoInput input;
  input.setBuffer(text.data(), text.size());
  TeNodePtr<SoSeparator> again(SoDB::readAll(&input));
  ASSERT_TRUE(again);
  EXPECT_EQ(written(again.get()), text);
  const SoTeLodTerrain* b = terrainOf(again.get());
  ASSERT_TRUE(b);
  EXPECT_EQ(b->center.getValue(), SbVec3d(12345678.125, -7.5, 1));
  EXPECT_EQ(b->submission.getValue(), SoTeLodTerrain::DISPLAY_LISTS);
  EXPECT_EQ(b->maxTriangles.getValue(), 77);
  EXPECT_EQ(b->slice.getValue(), 0.0025f);
  EXPECT_TRUE(b->lodCamera.getValue());
}

TEST(SoTeLodTerrain, BadFieldsGiveOneWarningAndNothing) {
  const std::string folder = testing::TempDir();
  writeRaw(folder + "lod-good.raw", 33);
  writeRaw(folder + "lod-even.raw", 32);
  const std::string map = "heightFile \"" + folder + "lod-good.raw\" ";
  {
    const CoinWarnings warnings;
    EXPECT_GT(triangles(readScene("TeLodTerrain { " + map + "}").get()), 0);
    EXPECT_THAT(warnings.lines, testing::IsEmpty());
  }
  for (const std::string& fields : std::vector<std::string>{
           "", "heightFile \"/nonexistent.raw\"", "heightFile \"/dev/null\"",
           "heightFile \"" + folder + "lod-even.raw\"", map + "verticalUnit \"furlongs\"",
           map + "method \"\"", map + "method \"tesselation\"", map + "size 256 128 10",
           map + "size -1 -1 10", map + "size 1e12 1e12 10", map + "pixelError -1", map + "dial -1",
           map + "maxTriangles 0", map + "maxTriangles -5", map + "slice -1", map + "lodCamera Cube {}"}) {
    const CoinWarnings warnings;
    const auto root = readScene("TeLodTerrain { " + fields + " }");
    ASSERT_TRUE(root) << fields;
    EXPECT_EQ(triangles(root.get()), 0) << fields;
    EXPECT_EQ(emitted(root.get()).size(), 0u) << fields;
    EXPECT_TRUE(boxOf(root.get()).isEmpty()) << fields;
    EXPECT_EQ(warnings.lines.size(), 1u) << fields << ": " << testing::PrintToString(warnings.lines);
    EXPECT_FALSE(terrainOf(root.get())->getError().empty()) << fields;
  }
  std::filesystem::remove(folder + "lod-good.raw");
  std::filesystem::remove(folder + "lod-even.raw");
}

TEST(SoTeLodTerrain, NumbersThatNameNothingAreErrors) {
  const CoinWarnings warnings;
  const auto node = lodNode("brute");
  node->coloring = 2;
  EXPECT_THAT(node->getError(), testing::HasSubstr("coloring 2"));
  node->coloring = SoTeLodTerrain::HEIGHT;
  node->submission = 7;
  EXPECT_THAT(node->getError(), testing::HasSubstr("submission 7"));
  node->submission = SoTeLodTerrain::VBO_STREAM;
  EXPECT_GT(triangles(node.get()), 0);
  node->pixelError = std::nanf("");
  EXPECT_EQ(triangles(node.get()), 0);
  EXPECT_EQ(warnings.lines.size(), 3u);
  node->pixelError = 1;
  node->center.setValue(std::nan(""), 0, 0);
  EXPECT_EQ(triangles(node.get()), 0);
  node->center.setValue(0, 0, 0);
  EXPECT_GT(triangles(node.get()), 0);
}

TEST(SoTeLodTerrain, HeightsThatMethodsCannotHaveAreErrors) {
  const CoinWarnings warnings;
  const auto node = lodNode("brute");
  TeHeightMap holes = hillsMap(16);
  holes.at(3, 4) = std::nanf("");
  node->setHeights(std::make_shared<const TeHeightMap>(std::move(holes)));
  EXPECT_THAT(node->getError(), testing::HasSubstr("(3, 4)"));
  node->setHeights(std::make_shared<const TeHeightMap>(std::move(TeHeightMap::create(17, 33).value())));
  EXPECT_FALSE(node->getError().empty());
  EXPECT_EQ(triangles(node.get()), 0);
  node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(16)));
  EXPECT_EQ(node->getError(), "");
}

TEST(SoTeLodTerrain, CopiesHaveTheSameHeights) {
  const auto node = lodNode("seamless");
  const TeNodePtr<SoTeLodTerrain> copy(static_cast<SoTeLodTerrain*>(node->copy()));
  EXPECT_EQ(triangles(copy.get()), triangles(node.get()));
  EXPECT_EQ(boxOf(copy.get()), boxOf(node.get()));
}
