#include "nodes/lod/SoTeLodTerrain.h"

#include "render/TeLodShapeTest.h"

#include <Inventor/nodes/SoTexture2.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr int kWays = SoTeLodTerrain::DISPLAY_LISTS + 1;

class SoTeLodTerrainTest : public TeLodShapeTest {};

/// What every method must do beside what every SoTeLodShape must.
class EveryLodMethod : public TeLodShapeTest, public testing::WithParamInterface<std::string> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(SoTeLodTerrain, EveryLodMethod, testing::ValuesIn(TeLodMethods::names()), testName);

TEST_P(EveryLodMethod, NoBackgroundWithinFromAnywhere) {
  const auto node = lodNode(GetParam(), 256);
  expectNoBackgroundWithin(node.get(), 24, [&](int view) {
    node->pixelError = view % 3 == 0 ? 1.0f : 6.0f;
    node->geomorph = view % 4 == 3;
  });
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

TEST_P(EveryLodMethod, TellsWhatItsPictureIsWorth) {
  const auto node = lodNode(GetParam());
  const auto scene = overview(node.get());
  show(scene.get());
  const TeLodStatistics& statistics = node->statistics();
  EXPECT_GE(statistics.parts, 1);
  EXPECT_GT(statistics.visited, 0);
  if (lodTellsBound(GetParam())) {
    EXPECT_LE(statistics.errorBound, 2);
  }
  EXPECT_TRUE(statistics.isComplete);
  show(scene.get());
  EXPECT_EQ(statistics.bytesUploaded, 0); // at rest
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

TEST_F(SoTeLodTerrainTest, NeighboursAreNotDamagedByAnyWay) {
  TeGlNeighbour neighbour(context());
  for (int way = 0; way < kWays; way++) {
    const auto node = lodNode("seamless");
    node->submission = way;
    expectStateStays(neighbour, node.get());
    node->wireframe = way % 2;
    node->coloring = way % 3 ? SoTeLodTerrain::PLAIN : SoTeLodTerrain::HEIGHT;
    expectConesLookAsAlone(node.get());
  }
}

TEST_F(SoTeLodTerrainTest, NothingIsLeftInOpenGl) {
  for (const int way : {int(SoTeLodTerrain::VBO_STATIC), int(SoTeLodTerrain::VBO_STREAM),
                        int(SoTeLodTerrain::DISPLAY_LISTS)}) {
    const auto make = [&] {
      const auto node = lodNode("seamless");
      node->submission = way;
      return TeNodePtr<SoTeLodShape>(node.get());
    };
    expectNothingIsLeft(make, &TeLodSender::live, 1, [&](SoTeLodShape& node, SoNode* scene) {
      const TePicture before = show(scene);
      node.setHeights(std::make_shared<const TeHeightMap>(hillsMap(64)));
      EXPECT_NE(show(scene), before);
      node.setHeights(std::make_shared<const TeHeightMap>(hillsMap(128)));
      show(scene);
      EXPECT_EQ(show(scene), before);
    });
  }
}

TEST_F(SoTeLodTerrainTest, TwoContextsTakeTurns) {
  const auto node = lodNode("seamless");
  expectContextsTakeTurns(overview(node.get()).get(), 1, [&](int turn) {
    if (turn > 0) {
      EXPECT_EQ(node->statistics().bytesUploaded, 0);
    }
  });
}

// A slice ends at the first look at the clock: the mesh grows by a few triangles a frame, and is in the end
// the one that is chosen in one go.
TEST_F(SoTeLodTerrainTest, ASliceGoesOnUntilAllIsChosen) {
  const auto node = lodNode("roam", 512);
  node->slice = 1e-9f;
  const auto scene = overview(node.get());
  SceneChanges changes(scene.get());
  int frames = 0;
  std::int64_t before = 0;
  do {
    changes.count = 0;
    const TePicture picture = show(scene.get());
    SoDB::getSensorManager()->processDelayQueue(TRUE);
    frames++;
    EXPECT_EQ(changes.count > 0, !node->statistics().isComplete) << frames;
    EXPECT_EQ(enclosedBackground(picture), 0) << frames;
    EXPECT_GE(node->statistics().triangles, before) << frames;
    before = node->statistics().triangles;
  } while (changes.count > 0 && frames < 10000);
  EXPECT_GT(frames, 20);
  EXPECT_LT(frames, 10000);

  const auto whole = lodNode("roam", 512);
  const auto other = overview(whole.get());
  show(other.get());
  EXPECT_TRUE(whole->statistics().isComplete);
  EXPECT_EQ(node->statistics().triangles, whole->statistics().triangles);
  EXPECT_EQ(node->statistics().errorBound, whole->statistics().errorBound);
  const auto sorted = [](SoNode* root) {
    std::vector<std::vector<float>> numbers;
    for (const EmittedTriangle& t : emitted(root, kPicture)) {
      std::vector<float>& of = numbers.emplace_back();
      for (const SbVec3f& corner : t)
        of.insert(of.end(), corner.getValue(), corner.getValue() + 3);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  };
  EXPECT_EQ(sorted(scene.get()), sorted(other.get()));
}
