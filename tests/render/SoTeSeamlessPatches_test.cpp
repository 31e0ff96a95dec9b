#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "nodes/coinWarnings.h"
#include "nodes/seamless/TeSeamlessObjects.h"
#include "render/TeGlNeighbour.h"
#include "render/TeSeamlessNodeTest.h"
#include "render/comparePixels.h"
#include "render/glObjects.h"
#include "render/magenta.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/sensors/SoNodeSensor.h>
#include <Inventor/sensors/SoSensorManager.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace {

class SoTeSeamlessPatchesTest : public TeSeamlessNodeTest {};

std::string picturesFolder() {
  return testing::TempDir() + "seamless-pictures-" + std::to_string(::getpid());
}

/// A picture of one colour but for a quarter.
std::string writePicture(const std::string& name, TePicture::Pixel colour, TePicture::Pixel southWest) {
  std::filesystem::create_directories(picturesFolder());
  TePicture picture;
  picture.width = picture.height = 32;
  for (int y = 0; y < 32; y++) {
    for (int x = 0; x < 32; x++)
      for (const std::uint8_t channel : x < 16 && y < 16 ? southWest : colour)
        picture.rgba.push_back(channel);
  }
  const std::string path = picturesFolder() + "/" + name + ".png";
  EXPECT_TRUE(picture.writePng(path));
  return path;
}

} // namespace

TEST_F(SoTeSeamlessPatchesTest, DrawsTilesAndStripsWithoutAGap) {
  const auto node = hillsNode();
  const TePicture picture = show(overview(node.get()).get(), "plain");
  EXPECT_EQ(enclosedBackground(picture), 0);
  EXPECT_LT(countMagenta(picture), 320 * 240 * 3 / 5);
  int white = 0, red = 0;
  for (int y = 0; y < picture.height; y++) {
    for (int x = 0; x < picture.width; x++) {
      const TePicture::Pixel p = picture.pixel(x, y);
      white += p[0] > 60 && p[1] > 60 && p[2] > 60;
      red += p[0] > 60 && p[1] < 20 && p[2] < 20;
    }
  }
  EXPECT_GT(white, 10000);
  EXPECT_GT(red, 500);
  const TeSeamlessStatistics& statistics = node->statistics();
  EXPECT_GT(statistics.faces, 1000);
  EXPECT_GT(statistics.drawCalls, 0);
  EXPECT_GE(statistics.traversed, statistics.rendered + statistics.culled);
  EXPECT_GT(statistics.selectionSeconds, 0);
  EXPECT_GT(statistics.errorBound, 0);
  EXPECT_GE(statistics.precision, 2);
  EXPECT_EQ(statistics.programs, 1);
  EXPECT_GT(statistics.bytesUploaded, 0);
}

// The rim of the square is all that may be seen of the background.
TEST_F(SoTeSeamlessPatchesTest, NoBackgroundWithinFromAnywhere) {
  std::mt19937 numbers(9);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto node = hillsNode(1024);
  int covered = 0;
  for (int i = 0; i < 40; i++) {
    node->precision = 1.0f + float(i % 4);
    node->pixelError = i % 8 == 7 ? 3.0f : 0.0f;
    node->geomorph = i % 3 == 2;
    const SbVec3f eye(430 * number(numbers), 430 * number(numbers), 160 + 60 * number(numbers));
    const SbVec3f ahead(number(numbers), number(numbers), -1.2f);
    const auto scene = seenBy(eye, eye + ahead, node.get());
    auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
    camera->nearDistance = 0.1f;
    const TePicture picture = show(scene.get(), "", 200, 150);
    EXPECT_EQ(enclosedBackground(picture), 0) << i;
    covered += 200 * 150 - countMagenta(picture);
  }
  EXPECT_GT(covered, 40 * 200 * 150 / 3);
}

TEST_F(SoTeSeamlessPatchesTest, ClassicAndInstancedAreTheSamePicture) {
  const HillsPyramid pyramid(256);
  for (const auto& node : {hillsNode(), pyramid.node(129)}) {
    const auto scene = overview(node.get());
    TePicture instanced, classic;
    settle(scene.get(), instanced);
    const auto calls = node->statistics().drawCalls;
    node->instancing = FALSE;
    settle(scene.get(), classic);
    EXPECT_EQ(instanced, classic);
    EXPECT_GT(node->statistics().drawCalls, calls);
  }
}

TEST_F(SoTeSeamlessPatchesTest, WholePatchesAreTheSamePictureWithFewerCalls) {
  const HillsPyramid pyramid(256);
  for (const auto& node : {hillsNode(), pyramid.node(129)}) {
    node->coloring = SoTeSeamlessPatches::HEIGHT;
    const auto scene = overview(node.get());
    for (const bool geomorph : {false, true}) {
      node->geomorph = geomorph;
      for (const bool instanced : {true, false}) {
        node->instancing = instanced;
        node->wholePatches = TRUE;
        TePicture whole, parts;
        settle(scene.get(), whole);
        const TeSeamlessStatistics before = node->statistics();
        node->wholePatches = FALSE;
        settle(scene.get(), parts);
        // Four strips share the centre of a patch, whose normal in a clipmap follows their resolutions.
        EXPECT_LE(comparePixels(whole, parts).pixels, 20);
        EXPECT_EQ(node->statistics().faces, before.faces);
        EXPECT_GT(node->statistics().drawCalls, before.drawCalls);
      }
    }
  }
}

TEST_F(SoTeSeamlessPatchesTest, CountsWhatItDraws) {
  const auto node = hillsNode();
  const auto scene = overview(node.get());
  show(scene.get());
  SoGetPrimitiveCountAction count(SbViewportRegion(320, 240));
  count.apply(scene.get());
  EXPECT_EQ(count.getTriangleCount(), int(node->statistics().faces));
}

// What rays meet is what the depth of the picture shows: a small ball on the picked point is half hidden.
TEST_F(SoTeSeamlessPatchesTest, PicksThePixelThatIsDrawn) {
  const auto node = hillsNode();
  const auto scene = overview(node.get());
  const TePicture picture = show(scene.get());
  SoRayPickAction pick(SbViewportRegion(320, 240));
  int agreed = 0, compared = 0;
  for (int y = 5; y < 240; y += 10) {
    for (int x = 5; x < 320; x += 10) {
      pick.setPoint(SbVec2s(short(x), short(y)));
      pick.setRadius(0.01f);
      pick.apply(scene.get());
      compared++;
      agreed += (pick.getPickedPoint() != nullptr) == (picture.pixel(x, y) != kMagenta);
    }
  }
  EXPECT_GE(agreed, compared - 8); // pixels on the rim
}

TEST_F(SoTeSeamlessPatchesTest, AllColourings) {
  const auto node = hillsNode();
  const auto scene = overview(node.get());
  const TePicture plain = show(scene.get());
  const auto expectOther = [&](const std::string& name, const TePicture& picture) {
    EXPECT_EQ(node->getError(), "") << name;
    EXPECT_EQ(enclosedBackground(picture), 0) << name;
    EXPECT_GT(comparePixels(plain, picture).pixels, 10000) << name;
  };
  node->texture = writePicture("texture", {40, 200, 40, 255}, {40, 40, 200, 255}).c_str();
  node->coloring = SoTeSeamlessPatches::TEXTURE;
  const TePicture texture = show(scene.get(), "texture");
  expectOther("texture", texture);
  int green = 0, blue = 0;
  for (int y = 0; y < 240; y++) {
    for (int x = 0; x < 320; x++) {
      green += texture.pixel(x, y)[1] > 2 * texture.pixel(x, y)[2];
      blue += texture.pixel(x, y)[2] > 2 * texture.pixel(x, y)[1] && texture.pixel(x, y) != kMagenta;
    }
  }
  EXPECT_GT(green, 8000);
  EXPECT_GT(blue, 8000); // the south-west is in front

  node->mask = writePicture("mask", {255, 0, 0, 0}, {0, 0, 255, 0}).c_str();
  for (int i = 0; i < 4; i++)
    node->detailTextures.set1Value(
        i, writePicture("detail" + std::to_string(i), {std::uint8_t(60 * i), 255, 0, 255}, {0, 0, 0, 255})
               .c_str());
  node->coloring = SoTeSeamlessPatches::DETAIL;
  expectOther("detail", show(scene.get(), "detail"));
  node->coloring = SoTeSeamlessPatches::HEIGHT;
  expectOther("height", show(scene.get(), "height"));
  const HillsPyramid colours(256, true);
  auto* clipmap = new SoTeClipmap;
  clipmap->name = colours.name().c_str();
  clipmap->kind = SoTeClipmap::COLOR;
  clipmap->size = 129;
  node->colors = clipmap;
  node->coloring = SoTeSeamlessPatches::TEXTURE;
  TePicture picture;
  settle(scene.get(), picture);
  expectOther("colour clipmap", picture);
  std::filesystem::remove_all(picturesFolder());
}

TEST_F(SoTeSeamlessPatchesTest, WireframeLeavesMostOfTheBackground) {
  const auto node = hillsNode(64);
  node->precision = 1;
  const auto scene = seenBy(SbVec3f(0, -100, 900), SbVec3f(0, 0, 80), node.get());
  const int solid = countMagenta(show(scene.get(), "", 640, 480));
  node->wireframe = TRUE;
  const int wires = countMagenta(show(scene.get(), "wireframe", 640, 480));
  EXPECT_GT(wires, solid + 50000);
  EXPECT_LT(wires, 640 * 480 - 5000);
}

TEST_F(SoTeSeamlessPatchesTest, BoundingBoxComplexityDrawsTheBox) {
  const auto node = hillsNode();
  const auto scene = overview(node.get());
  auto* complexity = new SoComplexity;
  complexity->type = SoComplexity::BOUNDING_BOX;
  scene->insertChild(complexity, 1);
  const TePicture box = show(scene.get(), "box");
  EXPECT_LT(countMagenta(box), 320 * 240 - 5000);
  EXPECT_EQ(node->statistics().faces, 0);
}

// Drawn small under a transform: the same picture as large without, up to single pixels of edges.
TEST_F(SoTeSeamlessPatchesTest, StandsUnderTransforms) {
  const auto plain = hillsNode();
  TePicture wanted = show(overview(plain.get()).get());
  auto* turn = new SoTransform;
  turn->rotation.setValue(SbVec3f(0, 0, 1), float(M_PI / 2));
  turn->scaleFactor.setValue(20, 10, 5);
  turn->translation.setValue(3, 4, -7);
  auto* back = new SoTransform;
  back->translation = -turn->translation.getValue();
  TeNodePtr<SoSeparator> group(new SoSeparator);
  auto* undo = new SoTransform; // the inverse: first away, then turned back and shrunk
  undo->rotation.setValue(SbVec3f(0, 0, 1), -float(M_PI / 2));
  auto* shrink = new SoTransform;
  shrink->scaleFactor.setValue(0.05f, 0.1f, 0.2f);
  group->addChild(turn);
  group->addChild(shrink);
  group->addChild(undo);
  group->addChild(plain.get());
  auto* there = new SoTranslation;
  there->translation = -turn->translation.getValue();
  group->insertChild(there, 0);
  const TePixelDifference difference = comparePixels(wanted, show(overview(group.get()).get(), "transforms"));
  EXPECT_LT(difference.pixels, 320 * 240 / 20);
}

// The primitives that actions get, drawn by Coin in their place, cover the same pixels.
TEST_F(SoTeSeamlessPatchesTest, CoinDrawsThePrimitivesAlike) {
  const HillsPyramid pyramid(256);
  for (const bool stretched : {false, true}) {
    for (const auto& node : {hillsNode(), pyramid.node(65)}) {
      auto* transform = new SoTransform;
      if (stretched) {
        transform->scaleFactor.setValue(1, 0.5f, 3);
        transform->rotation.setValue(SbVec3f(1, 0, 1), 0.3f);
      }
      TeNodePtr<SoSeparator> group(new SoSeparator);
      group->addChild(transform);
      group->addChild(node.get());
      const auto scene = overview(group.get());
      TePicture ours;
      settle(scene.get(), ours);
      auto* points = new SoCoordinate3;
      points->point.setNum(0);
      SoCallbackAction action(SbViewportRegion(320, 240));
      action.addTriangleCallback(
          SoTeSeamlessPatches::getClassTypeId(),
          [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
             const SoPrimitiveVertex* c) {
            auto& point = static_cast<SoCoordinate3*>(data)->point;
            for (const SoPrimitiveVertex* vertex : {a, b, c})
              point.set1Value(point.getNum(), vertex->getPoint());
          },
          points);
      action.apply(scene.get());
      EXPECT_EQ(points->point.getNum() / 3, node->statistics().faces);
      group->replaceChild(1, points);
      auto* faces = new SoFaceSet;
      for (int i = 0; i < points->point.getNum() / 3; i++)
        faces->numVertices.set1Value(i, 3);
      group->addChild(faces);
      const TePicture coins = show(scene.get(), stretched ? "stretched" : "");
      int differ = 0;
      for (int y = 0; y < 240; y++) {
        for (int x = 0; x < 320; x++)
          differ += (ours.pixel(x, y) == kMagenta) != (coins.pixel(x, y) == kMagenta);
      }
      EXPECT_LE(differ, 10) << stretched; // a pixel's middle may lie on an edge
      EXPECT_GT(320 * 240 - countMagenta(ours), 10000);
    }
  }
}

TEST_F(SoTeSeamlessPatchesTest, TwiceInOneScene) {
  const HillsPyramid pyramid(512);
  for (const auto& node : {hillsNode(512), pyramid.node(65, 1000, 20000)}) {
    TeNodePtr<SoSeparator> both(new SoSeparator);
    both->addChild(node.get());
    auto* aside = new SoTranslation;
    aside->translation.setValue(1200, 500, 0);
    both->addChild(aside);
    both->addChild(node.get());
    TePicture picture;
    const int frames = settle(overview(both.get()).get(), picture);
    std::printf("twice in one scene: at rest after %d frames\n", frames);
    EXPECT_EQ(enclosedBackground(picture), 0);
    TePicture one;
    settle(overview(node.get()).get(), one);
    EXPECT_LT(countMagenta(picture), countMagenta(one) - 1000);
  }
}

TEST_F(SoTeSeamlessPatchesTest, NeighboursAreNotDamaged) {
  TeGlNeighbour neighbour(context());
  const HillsPyramid pyramid(256);
  for (const auto& node : {hillsNode(), pyramid.node(65)}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    group->addChild(neighbour.before().get());
    group->addChild(node.get());
    group->addChild(neighbour.after().get());
    show(overview(group.get()).get());
  }
  EXPECT_EQ(neighbour.looks, 2);
  EXPECT_EQ(neighbour.changes, 0);

  // Coin's own shapes before and after look as they do alone.
  const auto cones = [](SoNode* between) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    for (const float x : {-150.0f, 150.0f}) {
      auto* part = new SoSeparator;
      auto* place = new SoTransform;
      place->translation.setValue(x, -300, 400);
      place->scaleFactor.setValue(90, 90, 90);
      auto* colour = new SoMaterial;
      colour->diffuseColor.setValue(0, x > 0 ? 1.0f : 0.2f, 1);
      part->addChild(colour);
      part->addChild(place);
      part->addChild(new SoCone);
      group->addChild(part);
      if (between && x < 0)
        group->addChild(between);
    }
    return group;
  };
  const TePicture alone = show(overview(cones(nullptr).get()).get());
  const TePicture together = show(overview(cones(hillsNode().get()).get()).get(), "neighbours");
  int compared = 0;
  for (int y = 0; y < 240; y++) {
    for (int x = 0; x < 320; x++) {
      if (alone.pixel(x, y) == kMagenta)
        continue;
      compared++;
      EXPECT_EQ(alone.pixel(x, y), together.pixel(x, y)) << x << " " << y;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST_F(SoTeSeamlessPatchesTest, NothingIsLeftInOpenGl) {
  TeNodePtr<SoSeparator> empty(new SoSeparator);
  empty->addChild(new SoPerspectiveCamera);
  show(empty.get());
  const int before = glObjects(context());
  {
    const HillsPyramid pyramid(256);
    auto node = pyramid.node(65);
    auto scene = overview(node.get());
    TePicture first;
    settle(scene.get(), first);
    const int drawn = glObjects(context());
    EXPECT_GT(drawn, before);
    // Other heights: what the old ones had goes.
    node->resolution = 128;
    TePicture second;
    settle(scene.get(), second);
    show(scene.get());
    EXPECT_EQ(glObjects(context()), drawn);
    // A second context, and its end.
    const std::int64_t live = TeSeamlessObjects::live();
    {
      auto other = TeContext::create(s_kind, 64, 64);
      ASSERT_TRUE(other);
      ASSERT_TRUE((*other)->makeCurrent());
      auto renderer = TeSceneRenderer::create(**other, 64, 64);
      ASSERT_TRUE(renderer);
      EXPECT_TRUE((*renderer)->render(scene.get()));
      EXPECT_GT(glObjects(**other), 0);
      EXPECT_GT(TeSeamlessObjects::live(), live);
      renderer->reset();
    }
    EXPECT_EQ(TeSeamlessObjects::live(), live);
    ASSERT_TRUE(context().makeCurrent());
    EXPECT_EQ(glObjects(context()), drawn);
    EXPECT_EQ(show(scene.get()), second);
  }
  // The node is gone; its objects go with the next frame in their context.
  show(empty.get());
  EXPECT_EQ(glObjects(context()), before);
}

TEST_F(SoTeSeamlessPatchesTest, NothingIsKeptForAContextThatEndsAfterTheNode) {
  const HillsPyramid pyramid(256);
  const std::int64_t live = TeSeamlessObjects::live();
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  ASSERT_TRUE((*other)->makeCurrent());
  {
    auto renderer = TeSceneRenderer::create(**other, 64, 64);
    ASSERT_TRUE(renderer);
    EXPECT_TRUE((*renderer)->render(overview(pyramid.node(65).get()).get()));
    EXPECT_TRUE((*renderer)->render(overview(hillsNode().get()).get()));
  }
  EXPECT_GT(TeSeamlessObjects::live(), live); // the nodes are gone already
  other->reset();
  EXPECT_EQ(TeSeamlessObjects::live(), live);
  ASSERT_TRUE(context().makeCurrent());
}

// What could not be drawn is nothing to actions either, not a plain.
TEST_F(SoTeSeamlessPatchesTest, HeightsThatCannotBeReadAreNotDrawnAndNotMet) {
  const HillsPyramid pyramid(256);
  const auto node = pyramid.node(257);
  static_cast<SoTeClipmap*>(node->heights.getValue())->cacheBytes = 0;
  const auto scene = overview(node.get());
  const CoinWarnings warnings;
  EXPECT_EQ(node->getError(), ""); // read once
  std::filesystem::resize_file(tePyramidLevelFile(pyramid.name(), pyramid.top()), 100);
  const TePicture picture = show(scene.get());
  EXPECT_EQ(countMagenta(picture), 320 * 240);
  EXPECT_EQ(warnings.lines.size(), 1u);
  SoRayPickAction pick(SbViewportRegion(320, 240));
  pick.setRay(SbVec3f(10, 20, 1000), SbVec3f(0, 0, -1));
  pick.apply(scene.get());
  EXPECT_FALSE(pick.getPickedPoint());
  SoGetPrimitiveCountAction count(SbViewportRegion(320, 240));
  count.apply(scene.get());
  EXPECT_EQ(count.getTriangleCount(), 0);
}

// As with Coin's own shapes.
TEST_F(SoTeSeamlessPatchesTest, ShapeHintsDoNotTurnItInsideOut) {
  const int alone = countMagenta(show(overview(hillsNode().get()).get()));
  for (const auto order : {SoShapeHints::CLOCKWISE, SoShapeHints::COUNTERCLOCKWISE}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    auto* hints = new SoShapeHints;
    hints->vertexOrdering = order;
    hints->shapeType = SoShapeHints::SOLID;
    group->addChild(hints);
    group->addChild(hillsNode().get());
    EXPECT_EQ(countMagenta(show(overview(group.get()).get())), alone) << order;
  }
}

TEST_F(SoTeSeamlessPatchesTest, TwoContextsTakeTurns) {
  const HillsPyramid pyramid(512);
  const auto node = pyramid.node(129);
  const auto scene = overview(node.get());
  TePicture first;
  settle(scene.get(), first);
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  for (int i = 0; i < 3; i++) {
    ASSERT_TRUE((*other)->makeCurrent());
    auto renderer = TeSceneRenderer::create(**other, 320, 240);
    ASSERT_TRUE(renderer);
    (*renderer)->setBackground(SbColor(1, 0, 1));
    (*renderer)->setFitClipPlanes(false);
    TePicture second;
    for (int frame = 0; frame < 20; frame++)
      second = std::move(*(*renderer)->render(scene.get()));
    EXPECT_EQ(second, first);
    renderer->reset();
    ASSERT_TRUE(context().makeCurrent());
    EXPECT_EQ(show(scene.get()), first);
  }
}

TEST_F(SoTeSeamlessPatchesTest, ClipmapsWhileTheyLoad) {
  const HillsPyramid pyramid(1024);
  const auto node = pyramid.node(129, 1000, 3000); // some rows a frame
  node->precision = 6;
  const auto scene = seenBy(SbVec3f(-350, -350, 230), SbVec3f(100, 50, 60), node.get());
  addSun(scene.get());
  int changes = 0;
  SoNodeSensor sensor([](void* data, SoSensor*) { ++*static_cast<int*>(data); }, &changes);
  sensor.setPriority(0);
  sensor.attach(scene.get());
  int frames = 0;
  std::int64_t faces = 0;
  std::int64_t mostBytes = 0;
  do {
    changes = 0;
    const TePicture picture = show(scene.get(), frames == 0 ? "loading" : "");
    EXPECT_EQ(enclosedBackground(picture), 0) << frames;
    EXPECT_GE(node->statistics().faces, faces / 2) << frames;
    faces = node->statistics().faces;
    if (frames > 0)
      mostBytes = std::max(mostBytes, node->statistics().bytesUploaded);
    SoDB::getSensorManager()->processDelayQueue(TRUE);
    frames++;
  } while (changes > 0 && frames < 1000);
  std::printf("clip windows loaded in %d frames, at most %lld bytes in one\n", frames,
              static_cast<long long>(mostBytes));
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 1000);
  EXPECT_LT(mostBytes, 200000);
  // At rest: nothing is chosen or uploaded again, and nobody asks for a frame.
  changes = 0;
  show(scene.get());
  SoDB::getSensorManager()->processDelayQueue(TRUE);
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(node->statistics().selectionSeconds, 0);
}

TEST_F(SoTeSeamlessPatchesTest, SecondCameraShowsWhatTheFirstOneSees) {
  const auto node = hillsNode(1024);
  TeNodePtr<SoPerspectiveCamera> first(new SoPerspectiveCamera);
  first->position.setValue(-300, -300, 150);
  first->pointAt(SbVec3f(0, 0, 100), SbVec3f(0, 0, 1));
  first->nearDistance = 1;
  first->farDistance = 400;
  const auto scene = overview(node.get());
  const int all = countMagenta(show(scene.get()));
  node->lodCamera = first.get();
  EXPECT_GT(countMagenta(show(scene.get(), "second-camera")), all + 2000);
  const std::int64_t patches = node->statistics().rendered;
  EXPECT_GT(patches, 0);
  first->position.setValue(-300, -300, 5000); // the scene's camera stays
  show(scene.get());
  EXPECT_NE(node->statistics().rendered, patches);
}
