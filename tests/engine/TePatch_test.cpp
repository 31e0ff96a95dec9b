#include "engine/TePatch.h"

#include "engine/TeEngine.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

namespace {

const TePatch::Direction kAll[] = {TePatch::EAST, TePatch::NORTH_EAST, TePatch::NORTH, TePatch::NORTH_WEST,
                                   TePatch::WEST, TePatch::SOUTH_WEST, TePatch::SOUTH, TePatch::SOUTH_EAST};

class TePatchTest : public testing::Test {
protected:
  static void SetUpTestSuite() { SoDB::init(); }

  TePatch* build(std::int64_t x, std::int64_t y) {
    TePatch* patch = m_engine.getPatch(TePatchKey{x, y, 0});
    EXPECT_TRUE(patch->prepareBuildMaps() && patch->buildHMapFromBuildMaps()) << m_engine.lastError();
    return patch;
  }

  static int triangles(SoNode* node) {
    SoGetPrimitiveCountAction count;
    count.apply(node);
    return count.getTriangleCount();
  }

  TeEngine m_engine{SbVec2s(17, 17), SbVec2f(64.0f, 64.0f)};
};

TEST_F(TePatchTest, HeightsNeedMapsFirst) {
  TePatch* patch = m_engine.getPatch(SbVec2f(0, 0));
  EXPECT_FALSE(patch->buildHMapFromBuildMaps());
  EXPECT_NE(m_engine.lastError().find("(0, 0)"), std::string::npos) << m_engine.lastError();
  EXPECT_TRUE(patch->prepareBuildMaps());
  EXPECT_TRUE(patch->buildHMapFromBuildMaps());
  EXPECT_TRUE(patch->buildHMapFromBuildMaps());
}

TEST_F(TePatchTest, GraphNeedsHeights) {
  TePatch* patch = m_engine.getPatch(SbVec2f(0, 0));
  EXPECT_EQ(patch->getPatchGraph(), nullptr);
  EXPECT_FALSE(m_engine.lastError().empty());
  ASSERT_TRUE(patch->prepareBuildMaps());
  EXPECT_EQ(patch->getPatchGraph(), nullptr);
  ASSERT_TRUE(patch->buildHMapFromBuildMaps());
  EXPECT_NE(patch->getPatchGraph(), nullptr);
}

TEST_F(TePatchTest, SeamNeedsTheNeighboursThatMeetThere) {
  TePatch* patch = build(0, 0);
  for (const TePatch::Direction direction : kAll) {
    EXPECT_EQ(patch->getSeamGraph(direction), nullptr);
    EXPECT_FALSE(m_engine.lastError().empty());
  }
  TePatch* east = m_engine.getPatch(TePatchKey{1, 0, 0});
  EXPECT_EQ(patch->getSeamGraph(TePatch::EAST), nullptr) << "the neighbour has no heights yet";
  ASSERT_TRUE(east->prepareBuildMaps() && east->buildHMapFromBuildMaps());
  EXPECT_NE(patch->getSeamGraph(TePatch::EAST), nullptr);
  EXPECT_EQ(patch->getSeamGraph(TePatch::NORTH_EAST), nullptr) << "a corner square needs four patches";
  build(0, 1);
  build(1, 1);
  EXPECT_NE(patch->getSeamGraph(TePatch::NORTH_EAST), nullptr);
}

TEST_F(TePatchTest, UnknownDirectionIsAnError) {
  TePatch* patch = build(0, 0);
  EXPECT_EQ(patch->getSeamGraph(TePatch::Direction(8)), nullptr);
  EXPECT_EQ(patch->getSeamGraph(TePatch::Direction(-1)), nullptr);
}

TEST_F(TePatchTest, ASeamIsOneNodeForAllPatchesThatMeetThere) {
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++)
      build(x, y);
  TePatch* patch = m_engine.getPatch(TePatchKey{0, 0, 0});
  for (const TePatch::Direction direction : kAll) {
    const glm::ivec2 step = teStep(TeDirection(direction));
    TePatch* other = m_engine.getPatch(TePatchKey{step.x, step.y, 0});
    SoSeparator* seam = patch->getSeamGraph(direction);
    ASSERT_NE(seam, nullptr) << m_engine.lastError();
    EXPECT_EQ(seam, other->getSeamGraph(TePatch::Direction((direction + 4) % 8)));
    EXPECT_EQ(seam, patch->getSeamGraph(direction)) << "kept for reuse";
  }
}

// 17 samples: 8 cells a side; inside 6×6, seam 2×6, corner square 2×2 cells, two triangles each.
TEST_F(TePatchTest, GraphsHoldTheTrianglesOfTheirParts) {
  TePatch* patch = build(0, 0);
  build(1, 0);
  build(0, 1);
  build(1, 1);
  EXPECT_EQ(triangles(patch->getPatchGraph()), 6 * 6 * 2);
  EXPECT_EQ(triangles(patch->getSeamGraph(TePatch::EAST)), 2 * 6 * 2);
  EXPECT_EQ(triangles(patch->getSeamGraph(TePatch::NORTH)), 2 * 6 * 2);
  EXPECT_EQ(triangles(patch->getSeamGraph(TePatch::NORTH_EAST)), 2 * 2 * 2);
}

TEST_F(TePatchTest, AGraphIsMadeOnce) {
  TePatch* patch = build(0, 0);
  EXPECT_EQ(patch->getPatchGraph(), patch->getPatchGraph());
}

} // namespace
