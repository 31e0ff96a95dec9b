#include "nodes/lod/SoTeLodTerrain.h"

#include "nodes/coinWarnings.h"
#include "nodes/lod/lodNode.h"
#include "render/TeGlNeighbour.h"
#include "render/TeSeamlessNodeTest.h"
#include "render/comparePixels.h"
#include "render/glObjects.h"
#include "render/magenta.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cstdio>
#include <random>

namespace {

constexpr int kWays = SoTeLodTerrain::DISPLAY_LISTS + 1;

class SoTeLodTerrainTest : public TeSeamlessNodeTest {};

/// What every method must do.
class EveryLodMethod : public TeSeamlessNodeTest, public testing::WithParamInterface<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodTerrain, EveryLodMethod, testing::ValuesIn(TeLodMethods::names()),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& letter : name)
                             letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
                           return name;
                         });

// The rim of the square is all that may be seen of the background.
TEST_P(EveryLodMethod, NoBackgroundWithinFromAnywhere) {
  std::mt19937 numbers(9);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto node = lodNode(GetParam(), 256);
  int covered = 0;
  for (int i = 0; i < 24; i++) {
    node->pixelError = i % 3 == 0 ? 1.0f : 6.0f;
    node->geomorph = i % 4 == 3;
    const SbVec3f eye(430 * number(numbers), 430 * number(numbers), 160 + 60 * number(numbers));
    const SbVec3f ahead(number(numbers), number(numbers), -1.2f);
    const auto scene = seenBy(eye, eye + ahead, node.get());
    static_cast<SoPerspectiveCamera*>(scene->getChild(0))->nearDistance = 0.1f;
    const TePicture picture = show(scene.get(), "", 200, 150);
    EXPECT_EQ(enclosedBackground(picture), 0) << i;
    covered += 200 * 150 - countMagenta(picture);
  }
  EXPECT_GT(covered, 24 * 200 * 150 / 3);
}

TEST_P(EveryLodMethod, AllWaysAreOnePicture) {
  const auto node = lodNode(GetParam());
  const auto scene = overview(node.get());
  for (const auto colours : {SoTeLodTerrain::PLAIN, SoTeLodTerrain::HEIGHT}) {
    node->coloring = colours;
    TePicture wanted;
    for (int way = 0; way < kWays; way++) {
      node->submission = way;
      for (int frame = 0; frame < 2; frame++) {
        const TePicture picture =
            show(scene.get(), way == 0 && frame == 0 && colours ? "lod-" + GetParam() : "");
        if (way == 0 && frame == 0)
          wanted = picture;
        // Calls and lists may convert the shorts of a normal otherwise than arrays.
        EXPECT_LE(comparePixels(picture, wanted).largest, 1) << way << " " << frame;
      }
    }
    EXPECT_EQ(enclosedBackground(wanted), 0);
    EXPECT_LT(countMagenta(wanted), 320 * 240 * 3 / 5);
  }
}

TEST_P(EveryLodMethod, CountsWhatItDrawsAndWhatItIsWorth) {
  const auto node = lodNode(GetParam());
  const auto scene = overview(node.get());
  show(scene.get());
  const TeLodStatistics& statistics = node->statistics();
  EXPECT_GT(statistics.triangles, 300);
  EXPECT_GT(statistics.drawCalls, 0);
  EXPECT_GE(statistics.parts, 1);
  EXPECT_GT(statistics.visited, 0);
  EXPECT_GT(statistics.selectionSeconds, 0);
  EXPECT_GT(statistics.bytesUploaded, 0);
  if (lodTellsBound(GetParam())) {
    EXPECT_LE(statistics.errorBound, 2);
  }
  EXPECT_TRUE(statistics.isComplete);
  SoGetPrimitiveCountAction count(SbViewportRegion(320, 240));
  count.apply(scene.get());
  EXPECT_EQ(count.getTriangleCount(), int(statistics.triangles));
  // At rest: nothing is chosen and nothing uploaded again, and nobody asks for a frame.
  TePicture picture;
  EXPECT_EQ(settle(scene.get(), picture), 1);
  show(scene.get());
  EXPECT_EQ(statistics.selectionSeconds, 0);
  EXPECT_EQ(statistics.bytesUploaded, 0);
}

// What rays meet is what the picture shows.
TEST_P(EveryLodMethod, PicksThePixelThatIsDrawn) {
  const auto node = lodNode(GetParam());
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

// The primitives that actions get, drawn by Coin in their place, cover the same pixels.
TEST_P(EveryLodMethod, CoinDrawsThePrimitivesAlike) {
  const auto node = lodNode(GetParam());
  for (const bool stretched : {false, true}) {
    auto* transform = new SoTransform;
    if (stretched) {
      transform->scaleFactor.setValue(1, 0.5f, 3);
      transform->rotation.setValue(SbVec3f(1, 0, 1), 0.3f);
    }
    TeNodePtr<SoSeparator> group(new SoSeparator);
    group->addChild(transform);
    group->addChild(node.get());
    const auto scene = overview(group.get());
    const TePicture ours = show(scene.get());
    std::vector<SbVec3f> corners;
    SoCallbackAction action(SbViewportRegion(320, 240));
    action.addTriangleCallback(
        SoTeLodTerrain::getClassTypeId(),
        [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
           const SoPrimitiveVertex* c) {
          for (const SoPrimitiveVertex* vertex : {a, b, c})
            static_cast<std::vector<SbVec3f>*>(data)->push_back(vertex->getPoint());
        },
        &corners);
    action.apply(scene.get());
    EXPECT_EQ(std::int64_t(corners.size()) / 3, node->statistics().triangles);
    auto* points = new SoCoordinate3;
    points->point.setValues(0, int(corners.size()), corners.data());
    auto* faces = new SoFaceSet;
    const std::vector<std::int32_t> threes(corners.size() / 3, 3);
    faces->numVertices.setValues(0, int(threes.size()), threes.data());
    group->replaceChild(1, points);
    group->addChild(faces);
    const TePicture coins = show(scene.get());
    int differ = 0;
    for (int y = 0; y < 240; y++) {
      for (int x = 0; x < 320; x++)
        differ += (ours.pixel(x, y) == kMagenta) != (coins.pixel(x, y) == kMagenta);
    }
    EXPECT_LE(differ, 10) << stretched; // a pixel's middle may lie on an edge
    EXPECT_GT(320 * 240 - countMagenta(ours), 10000);
  }
}

TEST_P(EveryLodMethod, AFlightLeavesNoGapAndNoGarbage) {
  const auto node = lodNode(GetParam(), 256);
  node->pixelError = 4;
  const auto scene = seenBy(SbVec3f(0, 0, 200), SbVec3f(0, 100, 150), node.get());
  addSun(scene.get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  auto renderer = TeSceneRenderer::create(context(), 160, 120);
  ASSERT_TRUE(renderer);
  for (int i = 0; i < 40; i++) {
    camera->position.setValue(float(10 * i - 200), float(300 * std::sin(i * 0.1)), 190);
    camera->pointAt(SbVec3f(float(10 * i), 0, 60), SbVec3f(0, 0, 1));
    node->submission = i < 20 ? SoTeLodTerrain::VBO_STATIC : SoTeLodTerrain::DISPLAY_LISTS;
    const TePicture picture = frame(**renderer, scene.get());
    EXPECT_EQ(enclosedBackground(picture), 0) << i;
    if (lodTellsBound(GetParam())) {
      EXPECT_LE(node->statistics().errorBound, 4) << i;
    }
    EXPECT_LE(node->statistics().keptBytes, TeLodPartStore::kMostBytes);
    if (i % 10 != 9)
      continue;
    // The same as of a node that has no past, where the method has none.
    const auto fresh = lodNode(GetParam(), 256);
    fresh->pixelError = 4;
    const auto again = seenBy(camera->position.getValue(), SbVec3f(float(10 * i), 0, 60), fresh.get());
    addSun(again.get());
    const TePicture other = frame(**renderer, again.get());
    EXPECT_LT(comparePixels(picture, other).pixels, 160 * 120 / 8) << i;
  }
}

TEST_F(SoTeLodTerrainTest, StaticPartsAreUploadedOnce) {
  const auto node = lodNode("brute", 256);
  const auto scene = seenBy(SbVec3f(0, -100, 300), SbVec3f(0, 200, 0), node.get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  for (const int way : {int(SoTeLodTerrain::VBO_STATIC), int(SoTeLodTerrain::DISPLAY_LISTS)}) {
    node->submission = way;
    show(scene.get());
    const std::int64_t first = node->statistics().bytesUploaded;
    EXPECT_GT(first, 100000);
    // Turning: only what comes into view.
    camera->pointAt(SbVec3f(60, 200, 0), SbVec3f(0, 0, 1));
    show(scene.get());
    EXPECT_LT(node->statistics().bytesUploaded, first / 2);
    camera->pointAt(SbVec3f(0, 200, 0), SbVec3f(0, 0, 1));
    show(scene.get());
    EXPECT_EQ(node->statistics().bytesUploaded, 0);
  }
  node->submission = SoTeLodTerrain::INDEXED_ARRAYS;
  show(scene.get());
  const std::int64_t indexed = node->statistics().bytesUploaded;
  show(scene.get());
  EXPECT_EQ(node->statistics().bytesUploaded, indexed); // each time
  node->submission = SoTeLodTerrain::VERTEX_ARRAYS;
  show(scene.get());
  EXPECT_GT(node->statistics().bytesUploaded, 2 * indexed);
}

// Not under a display list that Coin is just making, either.
TEST_F(SoTeLodTerrainTest, CachesOfTheSceneDoNotBreakIt) {
  for (int way = 0; way < kWays; way++) {
    const auto node = lodNode("seamless");
    node->submission = way;
    const TePicture wanted = show(overview(node.get()).get());
    const auto scene = overview(node.get());
    scene->renderCaching = SoSeparator::ON;
    for (int i = 0; i < 4; i++)
      EXPECT_EQ(show(scene.get()), wanted) << way << " " << i;
  }
}

TEST_F(SoTeLodTerrainTest, NothingTremblesFarFromTheOrigin) {
  const auto node = lodNode("seamless", 256);
  const TePicture wanted = show(overview(node.get()).get());
  for (const double far : {1e6, 1e9}) {
    node->center.setValue(far, -far, 0);
    node->origin.setValue(far, -far, 0);
    EXPECT_EQ(show(overview(node.get()).get()), wanted) << far;
  }
}

TEST_F(SoTeLodTerrainTest, WireframeLeavesMostOfTheBackground) {
  const auto node = lodNode("seamless", 64);
  node->pixelError = 20;
  const auto scene = seenBy(SbVec3f(0, -100, 900), SbVec3f(0, 0, 80), node.get());
  const int solid = countMagenta(show(scene.get(), "", 640, 480));
  node->wireframe = TRUE;
  EXPECT_GT(countMagenta(show(scene.get(), "", 640, 480)), solid + 50000);
  EXPECT_LT(countMagenta(show(scene.get(), "", 640, 480)), 640 * 480 - 2000);
}

TEST_F(SoTeLodTerrainTest, MaterialAndOverrideHaveTheirSay) {
  const auto node = lodNode("brute");
  const auto plain = [&](const SbColor& colour, bool overrides) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    auto* material = new SoMaterial;
    material->diffuseColor = colour;
    material->setOverride(overrides);
    group->addChild(material);
    group->addChild(node.get());
    return show(overview(group.get()).get());
  };
  const TePicture red = plain(SbColor(1, 0, 0), false);
  int redPixels = 0;
  for (int y = 0; y < 240; y++)
    for (int x = 0; x < 320; x++)
      redPixels += red.pixel(x, y)[0] > 60 && 2 * red.pixel(x, y)[2] < red.pixel(x, y)[0] &&
                   red.pixel(x, y) != kMagenta;
  EXPECT_GT(redPixels, 10000);
  node->coloring = SoTeLodTerrain::HEIGHT;
  EXPECT_GT(comparePixels(plain(SbColor(1, 0, 0), false), red).pixels, 10000);
  EXPECT_EQ(plain(SbColor(1, 0, 0), true), red);
}

TEST_F(SoTeLodTerrainTest, TexturesOfTheSceneAreNotUsedAndStay) {
  const auto cone = [](SoNode* before) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    auto* texture = new SoTexture2;
    const unsigned char pixels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0};
    texture->image.setValue(SbVec2s(2, 2), 3, pixels);
    group->addChild(texture);
    if (before)
      group->addChild(before);
    auto* place = new SoTransform;
    place->translation.setValue(0, -300, 400);
    place->scaleFactor.setValue(90, 90, 90);
    group->addChild(place);
    group->addChild(new SoCone);
    return group;
  };
  const TePicture terrain = show(overview(lodNode("seamless").get()).get());
  const TePicture alone = show(overview(cone(nullptr).get()).get());
  const TePicture both = show(overview(cone(lodNode("seamless").get()).get()).get());
  for (int y = 0; y < 240; y++)
    for (int x = 0; x < 320; x++)
      ASSERT_EQ(both.pixel(x, y), alone.pixel(x, y) == kMagenta ? terrain.pixel(x, y) : alone.pixel(x, y));
}

TEST_F(SoTeLodTerrainTest, BoundingBoxComplexityDrawsTheBox) {
  const auto node = lodNode("seamless");
  const auto scene = overview(node.get());
  auto* complexity = new SoComplexity;
  complexity->type = SoComplexity::BOUNDING_BOX;
  scene->insertChild(complexity, 1);
  EXPECT_LT(countMagenta(show(scene.get())), 320 * 240 - 5000);
  EXPECT_EQ(node->statistics().triangles, 0);
}

TEST_F(SoTeLodTerrainTest, TwiceInOneScene) {
  const auto node = lodNode("seamless", 256);
  TeNodePtr<SoSeparator> both(new SoSeparator);
  both->addChild(node.get());
  auto* aside = new SoTranslation;
  aside->translation.setValue(1200, 500, 0);
  both->addChild(aside);
  both->addChild(node.get());
  const auto scene = overview(both.get());
  TePicture picture;
  EXPECT_EQ(settle(scene.get(), picture), 1);
  EXPECT_EQ(enclosedBackground(picture), 0);
  EXPECT_LT(countMagenta(picture), countMagenta(show(overview(node.get()).get())) - 1000);
  show(scene.get());
  EXPECT_EQ(node->statistics().selectionSeconds, 0); // each place has a viewer of its own
}

TEST_F(SoTeLodTerrainTest, NeighboursAreNotDamaged) {
  TeGlNeighbour neighbour(context());
  const auto node = lodNode("seamless");
  for (int way = 0; way < kWays; way++) {
    node->submission = way;
    TeNodePtr<SoSeparator> group(new SoSeparator);
    group->addChild(neighbour.before().get());
    group->addChild(node.get());
    group->addChild(neighbour.after().get());
    show(overview(group.get()).get());
  }
  EXPECT_EQ(neighbour.looks, kWays);
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
  for (int way = 0; way < kWays; way++) {
    const auto terrain = lodNode("seamless");
    terrain->submission = way;
    terrain->wireframe = way % 2;
    terrain->coloring = way % 3 ? SoTeLodTerrain::PLAIN : SoTeLodTerrain::HEIGHT;
    const TePicture together = show(overview(cones(terrain.get()).get()).get());
    for (int y = 0; y < 240; y++)
      for (int x = 0; x < 320; x++)
        if (alone.pixel(x, y) != kMagenta) {
          ASSERT_EQ(alone.pixel(x, y), together.pixel(x, y)) << way << " " << x << " " << y;
        }
  }
}

// As with Coin's own shapes.
TEST_F(SoTeLodTerrainTest, ShapeHintsDoNotTurnItInsideOut) {
  const int alone = countMagenta(show(overview(lodNode("seamless").get()).get()));
  for (const auto order : {SoShapeHints::CLOCKWISE, SoShapeHints::COUNTERCLOCKWISE}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    auto* hints = new SoShapeHints;
    hints->vertexOrdering = order;
    hints->shapeType = SoShapeHints::SOLID;
    group->addChild(hints);
    group->addChild(lodNode("seamless").get());
    EXPECT_EQ(countMagenta(show(overview(group.get()).get())), alone) << order;
  }
}

TEST_F(SoTeLodTerrainTest, NothingIsLeftInOpenGl) {
  TeNodePtr<SoSeparator> empty(new SoSeparator);
  empty->addChild(new SoPerspectiveCamera);
  show(empty.get());
  const int before = glObjects(context());
  const std::int64_t none = TeLodSender::live();
  for (const int way : {int(SoTeLodTerrain::VBO_STATIC), int(SoTeLodTerrain::VBO_STREAM),
                        int(SoTeLodTerrain::DISPLAY_LISTS)}) {
    const auto node = lodNode("seamless");
    node->submission = way;
    const auto scene = overview(node.get());
    const TePicture first = show(scene.get());
    const int drawn = glObjects(context());
    EXPECT_GT(drawn, before);
    // Other heights: what the old ones had goes.
    node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(64)));
    show(scene.get());
    node->setHeights(std::make_shared<const TeHeightMap>(hillsMap(128)));
    show(scene.get());
    EXPECT_EQ(show(scene.get()), first);
    EXPECT_EQ(glObjects(context()), drawn);
    // A second context, and its end.
    const std::int64_t live = TeLodSender::live();
    {
      auto other = TeContext::create(s_kind, 64, 64);
      ASSERT_TRUE(other);
      ASSERT_TRUE((*other)->makeCurrent());
      auto renderer = TeSceneRenderer::create(**other, 64, 64);
      ASSERT_TRUE(renderer);
      EXPECT_TRUE((*renderer)->render(scene.get()));
      EXPECT_GT(TeLodSender::live(), live);
      renderer->reset();
    }
    EXPECT_EQ(TeLodSender::live(), live);
    ASSERT_TRUE(context().makeCurrent());
    EXPECT_EQ(glObjects(context()), drawn);
    EXPECT_LE(comparePixels(show(scene.get()), first).largest, 1);
  }
  // The nodes are gone; their objects go with the next frame in their context.
  show(empty.get());
  EXPECT_EQ(glObjects(context()), before);
  EXPECT_EQ(TeLodSender::live(), none);
}

TEST_F(SoTeLodTerrainTest, TwoContextsTakeTurns) {
  const auto node = lodNode("seamless");
  const auto scene = overview(node.get());
  const TePicture first = show(scene.get());
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  for (int i = 0; i < 3; i++) {
    ASSERT_TRUE((*other)->makeCurrent());
    {
      auto renderer = TeSceneRenderer::create(**other, 320, 240);
      ASSERT_TRUE(renderer);
      EXPECT_EQ(frame(**renderer, scene.get()), first);
      if (i > 0) {
        EXPECT_EQ(node->statistics().bytesUploaded, 0);
      }
    }
    ASSERT_TRUE(context().makeCurrent());
    EXPECT_EQ(show(scene.get()), first);
  }
}

TEST_F(SoTeLodTerrainTest, SecondCameraShowsWhatTheFirstOneSees) {
  const auto node = lodNode("seamless", 512);
  TeNodePtr<SoPerspectiveCamera> first(new SoPerspectiveCamera);
  first->position.setValue(-300, -300, 150);
  first->pointAt(SbVec3f(0, 0, 100), SbVec3f(0, 0, 1));
  first->nearDistance = 1;
  first->farDistance = 400;
  const auto scene = overview(node.get());
  const int all = countMagenta(show(scene.get()));
  node->lodCamera = first.get();
  EXPECT_GT(countMagenta(show(scene.get())), all + 2000);
  const std::int64_t triangles = node->statistics().triangles;
  EXPECT_GT(triangles, 0);
  first->position.setValue(-300, -300, 5000); // the scene's camera stays
  show(scene.get());
  EXPECT_NE(node->statistics().triangles, triangles);
}

TEST_F(SoTeLodTerrainTest, ViewsThatSeeNothingDrawNothing) {
  const CoinWarnings warnings;
  const auto node = lodNode("seamless");
  TeNodePtr<SoSeparator> group(new SoSeparator);
  auto* flat = new SoTransform;
  flat->scaleFactor.setValue(1, 1, 0);
  group->addChild(flat);
  group->addChild(node.get());
  EXPECT_EQ(countMagenta(show(overview(group.get()).get())), 320 * 240);
  EXPECT_EQ(node->statistics().triangles, 0);
}
