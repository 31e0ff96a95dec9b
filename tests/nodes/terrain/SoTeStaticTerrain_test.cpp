#include "nodes/terrain/SoTeStaticTerrain.h"

#include "nodes/SceneChanges.h"
#include "nodes/badFields.h"
#include "nodes/fileFormat.h"
#include "nodes/terrain/SoTeTerrainDetail.h"
#include "nodes/writtenScene.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoRotationXYZ.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTranslation.h>

#include <glm/geometric.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

template <class Node> int countNodes(SoNode* root) {
  SoSearchAction search;
  search.setType(Node::getClassTypeId());
  search.setInterest(SoSearchAction::ALL);
  search.apply(root);
  return search.getPaths().getLength();
}

/// Triangles of a block of N×N patches of n×n cells, the outermost strip of cells left out.
int blockTriangles(int patches, int cells) {
  const int side = patches * cells - 2;
  return 2 * side * side;
}

} // namespace

TEST(SoTeStaticTerrain, ShowsNinePatchesByDefault) {
  const auto root = readScene("TeStaticTerrain { seed 7 }");
  ASSERT_TRUE(root);
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 32));
}

TEST(SoTeStaticTerrain, EveryActionSeesTheTerrain) {
  const auto root = readScene("TeStaticTerrain { seed 7 samples 33 }");
  ASSERT_TRUE(root);
  SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
  ASSERT_TRUE(terrain);
  // 9 patches, 12 seams, 4 corners.
  EXPECT_EQ(countNodes<SoIndexedTriangleStripSet>(root.get()), 25);

  const SbBox3f box = boxOf(root.get());
  const float side = 3 * 16 * 1.0f;
  EXPECT_FLOAT_EQ(box.getMin()[0], -side / 2 + 1);
  EXPECT_FLOAT_EQ(box.getMax()[1], side / 2 - 1);
  EXPECT_GE(box.getMin()[2], terrain->getBlock()->minimum());
  EXPECT_LE(box.getMax()[2], terrain->getBlock()->maximum());
  EXPECT_GT(box.getMax()[2], box.getMin()[2]);

  EXPECT_EQ(int(emitted(root.get()).size()), blockTriangles(3, 16));
}

TEST(SoTeStaticTerrain, BlockOfAnySize) {
  for (int patches : {1, 2, 4, 5}) {
    const auto root = readScene("TeStaticTerrain { samples 17 block " + std::to_string(patches) + " }");
    ASSERT_TRUE(root);
    EXPECT_EQ(triangles(root.get()), blockTriangles(patches, 8)) << patches;
  }
}

TEST(SoTeStaticTerrain, HeaderTellsFieldsAndDefaults) {
  EXPECT_EQ(fieldsOf(TeNodePtr<SoTeStaticTerrain>(new SoTeStaticTerrain).get()),
            fileFormat("nodes/terrain/SoTeStaticTerrain.h"));
}

TEST(SoTeStaticTerrain, FieldsSurviveWritingAndReading) {
  const auto root =
      readScene("TeStaticTerrain { seed 18446744073709551615 generator \"faults:faults=20\" "
                "blending LINEAR samples 17 spacing 0.1 block 2 center 12345.125 -7.5 verticalScale 2 "
                "water TRUE waterLevel -1.5 colors [ 0 1 0, 0.5 0.5 0.5 ] colorHeights [ 3, 5 ] "
                "parts TRUE }");
  ASSERT_TRUE(root);
  const std::string text = written(root.get());
  const auto again = readAgain(root.get());
  const SoTeStaticTerrain* a = firstOf<SoTeStaticTerrain>(root.get());
  const SoTeStaticTerrain* b = firstOf<SoTeStaticTerrain>(again.get());
  ASSERT_TRUE(a && b);
  EXPECT_TRUE(a->fieldsAreEqual(b)) << text;
  EXPECT_EQ(b->seed.getValue(), "18446744073709551615");
  EXPECT_EQ(b->center.getValue(), SbVec2d(12345.125, -7.5));
  EXPECT_EQ(text.find("Coordinate3"), std::string::npos);
}

TEST(SoTeStaticTerrain, FieldChangesRebuild) {
  const auto root = readScene("TeStaticTerrain { samples 17 }");
  SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
  SceneChanges changes(root.get());
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 8));
  EXPECT_EQ(changes.count, 0); // building is no change: it would ask for another redraw
  terrain->block = 2;
  EXPECT_EQ(changes.count, 1);
  EXPECT_EQ(triangles(root.get()), blockTriangles(2, 8));
  EXPECT_EQ(changes.count, 1);
  SoSeparator* graph = terrain->getGraph();
  EXPECT_EQ(triangles(root.get()), blockTriangles(2, 8));
  EXPECT_EQ(terrain->getGraph(), graph); // not built again
  const double smooth = *terrain->getBlock()->database().heightAt({1.0, 2.0});
  terrain->blending = SoTeStaticTerrain::LINEAR;
  EXPECT_NE(*terrain->getBlock()->database().heightAt({1.0, 2.0}), smooth);
}

TEST(SoTeStaticTerrain, BadFieldsGiveOneWarningAndNothing) {
  for (const char* fields : {"seed \"7a\"",
                             "seed \"\"",
                             "seed \"-1\"",
                             "seed 18446744073709551616",
                             "generator \"nonsense\"",
                             "generator \"\"",
                             "generator \"faults:nonsense=1\"",
                             "filters \"nonsense\"",
                             "samples 0",
                             "samples -1",
                             "samples 64",
                             "samples 2147483647",
                             "spacing -1",

                             "spacing 1e300",
                             "block 0",
                             "block -3",
                             "block 1000000",
                             "center 1e300 0",
                             "verticalScale 0",
                             "colors [ 0 0 0, 0 0 0, 0 0 0, 0 0 0 ]",
                             "colors [ 2 0 0 ]",
                             "colorHeights [ 1 ]",
                             "image \"/nonexistent.png\"",
                             "file \"/nonexistent.tif\"",
                             "file \"/dev/null\"",
                             "file \"/dev/null\" verticalUnit \"furlongs\""})
    expectOneWarningAndNothing<SoTeStaticTerrain>(std::string("TeStaticTerrain { ") + fields + " }");
}

TEST(SoTeStaticTerrain, NotANumberIsOneWarning) {
  const auto root = readScene("TeStaticTerrain { samples 9 water TRUE colorHeights [ 1, 2 ] }");
  SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
  EXPECT_GT(triangles(root.get()), 0);
  const float nan = std::nanf("");
  terrain->spacing = double(nan);
  expectOneWarningAndNothing(root.get(), "spacing");
  terrain->spacing = 1;
  terrain->center.setValue(double(nan), 0);
  expectOneWarningAndNothing(root.get(), "center");
  terrain->center.setValue(0, 0);
  terrain->verticalScale = nan;
  expectOneWarningAndNothing(root.get(), "verticalScale");
  terrain->verticalScale = 1;
  terrain->waterLevel = nan;
  expectOneWarningAndNothing(root.get(), "waterLevel");
  terrain->waterLevel = 0;
  terrain->colorHeights.set1Value(0, nan);
  expectOneWarningAndNothing(root.get(), "colorHeights");
  terrain->colorHeights.set1Value(0, 1);
  EXPECT_GT(triangles(root.get()), 0);
}

TEST(SoTeStaticTerrain, GoodFieldsAfterBadOnesDraw) {
  const CoinWarnings warnings;
  const auto root = readScene("TeStaticTerrain { samples 16 }");
  EXPECT_EQ(triangles(root.get()), 0);
  firstOf<SoTeStaticTerrain>(root.get())->samples = 17;
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 8));
  EXPECT_TRUE(firstOf<SoTeStaticTerrain>(root.get())->getError().empty());
}

TEST(SoTeStaticTerrain, CopiesAndTwoInOneScene) {
  const auto root = readScene("Separator { DEF A TeStaticTerrain { samples 17 seed 1 } "
                              "TeStaticTerrain { samples 9 seed 2 } }");
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 8) + blockTriangles(3, 4));
  TeNodePtr<SoNode> copy(root->copy());
  EXPECT_EQ(triangles(copy.get()), blockTriangles(3, 8) + blockTriangles(3, 4));
  SoTeStaticTerrain* a = firstOf<SoTeStaticTerrain>(root.get());
  SoTeStaticTerrain* b = firstOf<SoTeStaticTerrain>(copy.get());
  EXPECT_NE(a, b);
  EXPECT_NE(a->getGraph(), b->getGraph());
  EXPECT_EQ(written(a->getGraph()), written(b->getGraph()));
  b->samples = 9;
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 8) + blockTriangles(3, 4));
}

TEST(SoTeStaticTerrain, PickTellsKeyAndPositionInDouble) {
  const auto root = readScene("TeStaticTerrain { seed 5 samples 33 center 1e9 -3e8 }");
  SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
  const TeStaticBlock* block = terrain->getBlock();
  ASSERT_TRUE(block);
  SoRayPickAction action(kViewport);
  int hits = 0;
  for (float x = -22.3f; x < 23; x += 3.7f) {
    for (float y = -22.9f; y < 23; y += 2.9f) {
      const SoPickedPoint* point = pickDown(action, root.get(), x, y);
      ASSERT_TRUE(point) << x << " " << y;
      const auto* detail = dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(terrain));
      ASSERT_TRUE(detail);
      const glm::dvec3 position = detail->getPosition();
      EXPECT_NEAR(position.x, block->centre().x + double(x), 1e-6);
      EXPECT_NEAR(position.y, block->centre().y + double(y), 1e-6);
      const std::optional<double> height = block->database().heightAt({position.x, position.y});
      ASSERT_TRUE(height);
      EXPECT_NEAR(detail->getHeight(), *height, 1e-6);
      EXPECT_NEAR(point->getPoint()[2], *height, 1e-3);
      EXPECT_EQ(detail->getPatchKey(), *tePatchAt(block->lattice(), {position.x, position.y}));
      EXPECT_NEAR(glm::length(detail->getNormal()), 1, 1e-12);
      EXPECT_GT(point->getNormal().dot(SbVec3f(0, 0, 1)), 0);
      hits++;
    }
  }
  std::printf("picked %d points at 1e9 m from the origin\n", hits);
}

TEST(SoTeStaticTerrain, PickMeetsWhatIsDrawn) {
  // Through the hidden graph Coin's own shapes are picked in float: both must meet the same surface.
  for (const char* fields : {"seed 5", "seed 6 verticalScale 3"}) {
    const auto root = readScene(std::string("TeStaticTerrain { samples 33 ") + fields + " }");
    SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
    SoSeparator* graph = terrain->getGraph();
    SoRayPickAction ours(kViewport);
    SoRayPickAction coins(kViewport);
    int both = 0;
    double worst = 0;
    for (int i = 0; i < 400; i++) {
      const SbVec3f from(float(i % 20) * 3 - 30, float(i / 20) * 3 - 30, 150);
      const SbVec3f along(std::sin(float(i)), std::cos(float(i)), -10);
      ours.setRay(from, along);
      ours.apply(root.get());
      coins.setRay(from, along);
      coins.apply(graph);
      const SoPickedPoint* a = ours.getPickedPoint();
      const SoPickedPoint* b = coins.getPickedPoint();
      EXPECT_EQ(a != nullptr, b != nullptr) << i;
      if (a && b) {
        worst = std::max(worst, double((a->getPoint() - b->getPoint()).length()));
        both++;
      }
    }
    EXPECT_GT(both, 100);
    EXPECT_LT(worst, 1e-3);
    std::printf("%s: %d rays meet both surfaces, at most %.2g m apart\n", fields, both, worst);
  }
}

TEST(SoTeStaticTerrain, PickGoesThroughTransformsAndStyles) {
  const auto moved = readScene("Separator { Translation { translation 100 0 0 } Scale { scaleFactor 2 2 2 } "
                               "TeStaticTerrain { samples 17 } }");
  SoRayPickAction action(kViewport);
  const SoPickedPoint* point = pickDown(action, moved.get(), 106, 4);
  ASSERT_TRUE(point);
  const auto* detail =
      dynamic_cast<const SoTeTerrainDetail*>(point->getDetail(firstOf<SoTeStaticTerrain>(moved.get())));
  ASSERT_TRUE(detail);
  EXPECT_NEAR(detail->getPosition().x, 3, 1e-5);
  EXPECT_NEAR(detail->getPosition().y, 2, 1e-5);
  EXPECT_FALSE(pickDown(action, moved.get(), 0, 0));

  const auto shy = readScene("Separator { PickStyle { style UNPICKABLE } TeStaticTerrain { samples 17 } }");
  EXPECT_FALSE(pickDown(action, shy.get(), 0, 0));
}

TEST(SoTeStaticTerrain, PickAllFindsEveryCrossing) {
  const auto root = readScene("TeStaticTerrain { samples 33 generator \"function:z=10*sin(x/2)\" }");
  SoRayPickAction action(kViewport);
  action.setPickAll(TRUE);
  action.setRay(SbVec3f(-20, 0.25f, 0.5f), SbVec3f(1, 0, 0));
  action.apply(root.get());
  // 40 m of a wave of 4 pi m length are crossed at half its height twice a length.
  EXPECT_NEAR(action.getPickedPointList().getLength(), 2 * (43 / 12.57), 1.5);
}

TEST(SoTeStaticTerrain, ImageIsDrapedFromBesideTheFile) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "drape";
  std::filesystem::create_directories(folder);
  TePicture picture;
  picture.width = picture.height = 4;
  picture.rgba.assign(64, 99);
  ASSERT_TRUE(picture.writePng((folder / "map.png").string()));
  std::ofstream(folder / "scene.iv")
      << "#Inventor V2.1 ascii\nTeStaticTerrain { samples 17 image \"map.png\" }\n";
  SoInput input;
  ASSERT_TRUE(input.openFile((folder / "scene.iv").c_str()));
  TeNodePtr<SoSeparator> root(SoDB::readAll(&input));
  ASSERT_TRUE(root);
  EXPECT_EQ(triangles(root.get()), blockTriangles(3, 8));
  EXPECT_GT(countNodes<SoTexture2>(root.get()), 0);
  TeNodePtr<SoNode> copy(root->copy());
  EXPECT_GT(countNodes<SoTexture2>(copy.get()), 0);
  std::filesystem::remove_all(folder);
}

TEST(SoTeStaticTerrain, ElevationDataCoversTheBlock) {
#ifndef TERRANE_TEST_WITH_GDAL
  GTEST_SKIP() << "built without GDAL";
#endif
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "elevation";
  std::filesystem::create_directories(folder);
  // 12 × 10 posts every 20 m; a peak of 90 m, and a void.
  std::ofstream grid(folder / "grid.asc");
  grid << "ncols 12\nnrows 10\nxllcorner 0\nyllcorner 0\ncellsize 20\nNODATA_value -9999\n";
  for (int row = 0; row < 10; row++) {
    for (int column = 0; column < 12; column++)
      grid << (row == 4 && column == 7 ? 90 : row == 8 && column == 2 ? -9999 : 10) << " ";
    grid << "\n";
  }
  grid.close();
  for (const char* fields :
       {"", "block 2", "native TRUE samples 9", "fillVoids TRUE", "verticalUnit \"dm\""}) {
    std::ofstream(folder / "scene.iv")
        << "#Inventor V2.1 ascii\nTeStaticTerrain { file \"grid.asc\" " << fields << " }\n";
    SoInput input;
    ASSERT_TRUE(input.openFile((folder / "scene.iv").c_str()));
    const TeNodePtr<SoSeparator> root(SoDB::readAll(&input));
    ASSERT_TRUE(root);
    SoTeStaticTerrain* terrain = firstOf<SoTeStaticTerrain>(root.get());
    const TeStaticBlock* block = terrain->getBlock();
    ASSERT_TRUE(block) << fields << ": " << terrain->getError();
    const bool native = std::string(fields).find("native") == 0;
    if (native) {
      EXPECT_EQ(block->lattice().spacing(), 20);
      EXPECT_EQ(block->database().heightAt({0, 0}), 90.0);
    } else {
      EXPECT_GE(block->lattice().spacing() * 32 * block->patches(), 219.9) << fields; // 12 posts wide
    }
    EXPECT_EQ(block->minimum(), std::string(fields).find("dm") != std::string::npos ? 1 : 10) << fields;
    EXPECT_GT(triangles(root.get()), 100) << fields;
    EXPECT_GE(boxOf(root.get()).getMin()[2], 0) << fields; // voids are never drawn
  }
  std::filesystem::remove_all(folder);
}
