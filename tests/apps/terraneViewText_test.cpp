// The lines that terrane-view writes over the picture.

#include "apps/terrane-view/TeViewText.h"
#include "nodes/TeNodes.h"

#include <Inventor/nodes/SoSeparator.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using Lines = std::vector<std::string>;
using testing::Contains;
using testing::ElementsAre;

class TerraneViewText : public testing::Test {
protected:
  TerraneViewText() { TeNodes::init(); }
};

TEST_F(TerraneViewText, ALodTerrainTellsWhatItDrewAndHowGoodThatIs) {
  const TeNodePtr<SoTeLodTerrain> node(new SoTeLodTerrain);
  node->method = "roam";
  node->pixelError = 2;
  TeLodStatistics figures;
  figures.triangles = 1234567;
  figures.drawCalls = 12;
  figures.bytesUploaded = 65536;
  figures.errorBound = 1.875;
  figures.dial = 3000;
  EXPECT_THAT(teLodLines(*node, figures),
              ElementsAre("method      roam", "triangles   1 234 567", "draw calls  12",
                          "uploaded    65 536 bytes", "error       at most 1.88 px  (dial 3000)",
                          "wanted      error 2.00 px"));
}

TEST_F(TerraneViewText, WithoutABoundOrADialItSaysSo) {
  const TeNodePtr<SoTeLodTerrain> node(new SoTeLodTerrain);
  TeLodStatistics figures;
  figures.errorBound = std::numeric_limits<double>::infinity();
  EXPECT_THAT(teLodLines(*node, figures), Contains("error       no bound"));
}

TEST_F(TerraneViewText, ADialGoesBeforeTheWantedError) {
  const TeNodePtr<SoTeLodTerrain> node(new SoTeLodTerrain);
  node->dial = 0.5f;
  node->geomorph = TRUE;
  EXPECT_THAT(teLodLines(*node, {}), Contains("wanted      dial 0.5  geomorph"));
}

TEST_F(TerraneViewText, EveryKindOfTerrainInASceneHasItsLines) {
  const TeNodePtr<SoSeparator> scene(new SoSeparator);
  const TeViewPose pose{{1, 2, 3.5}, {1, 0, 0, 0}};
  const Lines none = teViewLines(TeLodNodes(scene.get(), {}), pose, 0.0125);
  EXPECT_EQ(none, (Lines{"eye         1.0  2.0  3.5", "frame       12.5 ms"}));
  for (const char* method : {"roam", "brute"}) {
    auto* node = new SoTeLodTerrain;
    node->method = method;
    scene->addChild(node);
  }
  scene->addChild(new SoTeSeamlessPatches);
  const Lines all = teViewLines(TeLodNodes(scene.get(), {}), pose, 0);
  EXPECT_EQ(all.size(), 6u + 2 * 6 + 1);
  EXPECT_EQ(all.front().substr(0, 5), "faces");
  EXPECT_THAT(all, testing::AllOf(Contains("method      roam"), Contains("method      brute")));
}

TEST_F(TerraneViewText, LodTerrainsAreSetAndSummedUpToo) {
  const TeNodePtr<SoSeparator> scene(new SoSeparator);
  EXPECT_FALSE(TeLodNodes(scene.get(), {}).any());
  auto* node = new SoTeLodTerrain;
  scene->addChild(node);
  TeLodNodes nodes(scene.get(), {});
  EXPECT_TRUE(nodes.any());
  EXPECT_FALSE(nodes.anySeamless());
  EXPECT_EQ(nodes.pixelError(), 1);
  nodes.setPixelError(2.5);
  EXPECT_EQ(node->pixelError.getValue(), 2.5f);
  EXPECT_EQ(nodes.pixelError(), 2.5);
  for (const bool on : {true, false}) {
    nodes.setGeomorph(!nodes.geomorph());
    EXPECT_EQ(bool(node->geomorph.getValue()), on);
  }
}

} // namespace
