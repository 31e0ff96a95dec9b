#include "nodes/lod/SoTeLodShape.h"

#include "nodes/coinWarnings.h"
#include "render/TeLodShapeTest.h"

#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoShapeHints.h>

namespace {

/// What every shape must do, whichever method chooses its triangles …
class EveryLodShape : public TeLodShapeTest, public testing::WithParamInterface<std::string> {};

/// … and what does not depend on that: for one shape of each class.
class BothLodShapes : public TeLodShapeTest, public testing::WithParamInterface<std::string> {
protected:
  /// Pictures of one class are kept.
  std::string keptAs(const std::string& name) const { return GetParam() == kPatches ? name : ""; }
};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodShape, EveryLodShape, testing::ValuesIn(lodShapeNames()), testName);
INSTANTIATE_TEST_SUITE_P(SoTeLodShape, BothLodShapes, testing::Values("seamless", kPatches), testName);

TEST_P(EveryLodShape, CountsWhatItDraws) {
  const auto node = lodShape(GetParam());
  const auto scene = overview(node.get());
  show(scene.get());
  const LodShapeStatistics first = statisticsOf(*node);
  EXPECT_GT(first.triangles, 300);
  EXPECT_GT(first.drawCalls, 0);
  EXPECT_GT(first.selectionSeconds, 0);
  EXPECT_GT(first.bytesUploaded, 0);
  SoGetPrimitiveCountAction count(kPicture);
  count.apply(scene.get());
  EXPECT_EQ(count.getTriangleCount(), int(first.triangles));
  // At rest: nothing is chosen again, and nobody asks for a frame.
  TePicture picture;
  EXPECT_EQ(settle(scene.get(), picture), 1);
  show(scene.get());
  EXPECT_EQ(statisticsOf(*node).selectionSeconds, 0);
}

// What rays meet is what the picture shows.
TEST_P(EveryLodShape, PicksThePixelThatIsDrawn) {
  const auto node = lodShape(GetParam());
  const auto scene = overview(node.get());
  const TePicture picture = show(scene.get());
  SoRayPickAction pick(kPicture);
  int agreed = 0, compared = 0;
  for (int y = 5; y < kHeight; y += 10) {
    for (int x = 5; x < kWidth; x += 10) {
      pick.setPoint(SbVec2s(short(x), short(y)));
      pick.setRadius(0.01f);
      pick.apply(scene.get());
      compared++;
      agreed += (pick.getPickedPoint() != nullptr) == (picture.pixel(x, y) != kMagenta);
    }
  }
  EXPECT_GE(agreed, compared - 8); // pixels on the rim
}

TEST_P(EveryLodShape, CoinDrawsThePrimitivesAlike) {
  const auto node = lodShape(GetParam());
  for (const bool stretched : {false, true})
    expectCoinDrawsAlike(node.get(), stretched);
}

TEST_P(BothLodShapes, WireframeLeavesMostOfTheBackground) {
  const auto node = lodShape(GetParam(), 64);
  node->pixelError = 20;
  const auto scene = seenBy(SbVec3f(0, -100, 900), SbVec3f(0, 0, 80), node.get());
  const int solid = countMagenta(show(scene.get(), "", 640, 480));
  node->wireframe = TRUE;
  const int wires = countMagenta(show(scene.get(), keptAs("wireframe"), 640, 480));
  EXPECT_GT(wires, solid + 50000);
  EXPECT_LT(wires, 640 * 480 - 5000);
}

TEST_P(BothLodShapes, BoundingBoxComplexityDrawsTheBox) {
  const auto node = lodShape(GetParam());
  const auto scene = overview(node.get());
  auto* complexity = new SoComplexity;
  complexity->type = SoComplexity::BOUNDING_BOX;
  scene->insertChild(complexity, 1);
  EXPECT_LT(countMagenta(show(scene.get(), keptAs("box"))), kWidth * kHeight - 5000);
  EXPECT_EQ(statisticsOf(*node).triangles, 0);
}

TEST_P(BothLodShapes, TwiceInOneScene) {
  const auto node = lodShape(GetParam());
  EXPECT_EQ(expectTwiceInOneScene(node.get()), 1);
  EXPECT_EQ(statisticsOf(*node).selectionSeconds, 0); // each place has a viewer of its own
}

TEST_P(BothLodShapes, NeighboursAreNotDamaged) {
  TeGlNeighbour neighbour(context());
  const auto node = lodShape(GetParam());
  expectStateStays(neighbour, node.get());
  expectConesLookAsAlone(node.get(), keptAs("neighbours"));
}

// As with Coin's own shapes.
TEST_P(BothLodShapes, ShapeHintsDoNotTurnItInsideOut) {
  const int alone = countMagenta(show(overview(lodShape(GetParam()).get()).get()));
  for (const auto order : {SoShapeHints::CLOCKWISE, SoShapeHints::COUNTERCLOCKWISE}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    auto* hints = new SoShapeHints;
    hints->vertexOrdering = order;
    hints->shapeType = SoShapeHints::SOLID;
    group->addChild(hints);
    group->addChild(lodShape(GetParam()).get());
    EXPECT_EQ(countMagenta(show(overview(group.get()).get())), alone) << order;
  }
}

TEST_P(BothLodShapes, SecondCameraShowsWhatTheFirstOneSees) {
  const auto node = lodShape(GetParam(), 1024);
  TeNodePtr<SoPerspectiveCamera> first(new SoPerspectiveCamera);
  first->position.setValue(-300, -300, 150);
  first->pointAt(SbVec3f(0, 0, 100), SbVec3f(0, 0, 1));
  first->nearDistance = 1;
  first->farDistance = 400;
  const auto scene = overview(node.get());
  const int all = countMagenta(show(scene.get()));
  node->lodCamera = first.get();
  EXPECT_GT(countMagenta(show(scene.get(), keptAs("second-camera"))), all + 2000);
  const std::int64_t triangles = statisticsOf(*node).triangles;
  EXPECT_GT(triangles, 0);
  first->position.setValue(-300, -300, 5000); // the scene's camera stays
  show(scene.get());
  EXPECT_NE(statisticsOf(*node).triangles, triangles);
}

TEST_P(BothLodShapes, ViewsThatSeeNothingDrawNothing) {
  const CoinWarnings warnings;
  const auto node = lodShape(GetParam());
  TeNodePtr<SoSeparator> group(new SoSeparator);
  auto* flat = new SoTransform;
  flat->scaleFactor.setValue(1, 1, 0);
  group->addChild(flat);
  group->addChild(node.get());
  EXPECT_EQ(countMagenta(show(overview(group.get()).get())), kWidth * kHeight);
  EXPECT_EQ(statisticsOf(*node).triangles, 0);
}
