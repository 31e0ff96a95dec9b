#include "nodes/terrain/TeMeshDrawing.h"

#include <gtest/gtest.h>

// What is drawn is tested with a context: tests/render.

TEST(TeMeshDrawing, TranslatesFromTheOriginToTheAnchor) {
  TeMeshDrawing drawing({1e9 + 64, -1e9});
  drawing.setWorldOrigin({1e9, -1e9 - 32, 250});
  EXPECT_EQ(drawing.translation()->translation.getValue(), SbVec3f(64, 32, -250));
  drawing.setAnchor({1e9 - 64, -1e9 + 32});
  EXPECT_EQ(drawing.translation()->translation.getValue(), SbVec3f(-64, 64, -250));
}

TEST(TeMeshDrawing, TheAnchorMovesOnlyWithItsCommitment) {
  TeMeshDrawing drawing({0, 0});
  EXPECT_FALSE(drawing.nextAnchorReady());
  drawing.beginAnchor({128, 256});
  EXPECT_TRUE(drawing.changesAnchor());
  EXPECT_EQ(drawing.anchor(), glm::dvec2(0, 0));
  EXPECT_EQ(drawing.nextAnchor(), glm::dvec2(128, 256));
  EXPECT_FALSE(drawing.nextAnchorReady()); // before a frame was drawn
  EXPECT_EQ(drawing.translation()->translation.getValue(), SbVec3f(0, 0, 0));
  drawing.commitAnchor();
  EXPECT_FALSE(drawing.changesAnchor());
  EXPECT_EQ(drawing.anchor(), glm::dvec2(128, 256));
  EXPECT_EQ(drawing.translation()->translation.getValue(), SbVec3f(128, 256, 0));
}
