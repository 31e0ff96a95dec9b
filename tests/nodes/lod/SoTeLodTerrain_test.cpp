#include "nodes/lod/SoTeLodTerrain.h"

#include "nodes/badFields.h"
#include "nodes/fileFormat.h"
#include "nodes/lod/lodShape.h"
#include "nodes/rawFile.h"
#include "nodes/terrain/SoTeTerrainDetail.h"
#include "nodes/writtenScene.h"

#include <Inventor/nodes/SoComplexity.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace {

/// What every method must do beside what every SoTeLodShape must.
class EveryMethod : public testing::TestWithParam<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodTerrain, EveryMethod, testing::ValuesIn(TeLodMethods::names()), testName);

// Where nothing is drawn, too.
TEST_P(EveryMethod, RaysMeetAllSamplesBehindTheCamera) {
  const auto node = lodNode(GetParam());
  const auto behind = seenBy(SbVec3f(0, 0, 250), SbVec3f(0, 500, 100), node.get());
  const TeHeightMap map = hillsMap(128);
  SoRayPickAction pick(kViewport);
  for (int column = 5; column < 128; column += 31) {
    const float x = float(column) * 7.8125f - 500, y = 10 * 7.8125f - 500;
    const SoPickedPoint* point = pickDown(pick, behind.get(), x, y);
    ASSERT_TRUE(point) << column;
    EXPECT_NEAR(point->getPoint()[2], map.at(column, 10), 1e-2f);
  }
  EXPECT_FALSE(pickDown(pick, behind.get(), -510, -490));
}

TEST_P(EveryMethod, HitsTellTheCell) {
  const auto node = lodNode(GetParam());
  const auto root = seenBy(SbVec3f(-450, -450, 250), SbVec3f(0, 0, 100), node.get());
  SoRayPickAction pick(kViewport);
  for (float x = -430; x < 400; x += 71.7f) {
    const SoPickedPoint* point = pickDown(pick, root.get(), x, 0.6f * x + 13);
    ASSERT_TRUE(point) << x;
    const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(node.get()));
    ASSERT_TRUE(detail) << x;
    EXPECT_EQ(detail->getPatchKey().x, std::int64_t(std::floor((double(x) + 500) / 7.8125))) << x;
    EXPECT_EQ(detail->getPatchKey().y, std::int64_t(std::floor((0.6 * double(x) + 513) / 7.8125))) << x;
  }
}

TEST(SoTeLodTerrain, ComplexityMovesTheMethodsDialAlike) {
  const auto node = lodNode("seamless", 512);
  const auto root = seenBy(SbVec3f(0, -480, 160), SbVec3f(0, 0, 100), node.get());
  auto* complexity = new SoComplexity;
  root->insertChild(complexity, 1);
  node->dial = 3;
  const int three = triangles(root.get());
  node->dial = 1.5f;
  EXPECT_LT(triangles(root.get()), three);
  complexity->value = 0.75f; // twice as accurate
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

TEST(SoTeLodTerrain, HeaderTellsFieldsAndDefaults) {
  EXPECT_EQ(fieldsOf(TeNodePtr<SoTeLodTerrain>(new SoTeLodTerrain).get()),
            fileFormat("nodes/lod/SoTeLodTerrain.h"));
}

TEST(SoTeLodTerrain, FieldsSurviveWritingAndReading) {
  const auto root = readScene(
      "TeLodTerrain { method \"brute\" heightFile \"a.raw\" verticalUnit \"0.1\" size 5000 5000 300 "
      "pixelError 1.25 dial 7.5 geomorph TRUE maxTriangles 77 slice 0.0025 submission DISPLAY_LISTS "
      "wireframe TRUE coloring HEIGHT lodCamera PerspectiveCamera {} center 12345678.125 -7.5 1 "
      "origin 12345678 0 2 }");
  ASSERT_TRUE(root);
  const auto again = readAgain(root.get());
  const SoTeLodTerrain* b = firstOf<SoTeLodTerrain>(again.get());
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
           map + "maxTriangles 0", map + "maxTriangles -5", map + "slice -1", map + "lodCamera Cube {}"})
    expectOneWarningAndNothing<SoTeLodTerrain>("TeLodTerrain { " + fields + " }");
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
  EXPECT_EQ(warnings.lines.size(), 2u);
  for (const float number : {-1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    node->slice = number;
    EXPECT_THAT(node->getError(), testing::HasSubstr("slice "));
    EXPECT_EQ(triangles(node.get()), 0);
  }
  node->slice = 0;
  EXPECT_GT(triangles(node.get()), 0);
}

TEST(SoTeLodTerrain, SaysWhichSampleIsMissing) {
  const CoinWarnings warnings;
  const auto node = lodNode("brute");
  TeHeightMap holes = hillsMap(16);
  holes.at(3, 4) = std::nanf("");
  node->setHeights(std::make_shared<const TeHeightMap>(std::move(holes)));
  EXPECT_THAT(node->getError(), testing::HasSubstr("(3, 4)"));
}
