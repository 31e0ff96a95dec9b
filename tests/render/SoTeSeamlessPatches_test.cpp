#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "nodes/coinWarnings.h"
#include "nodes/seamless/TeSeamlessObjects.h"
#include "render/TeLodShapeTest.h"

#include <algorithm>
#include <cstdio>

namespace {

class SoTeSeamlessPatchesTest : public TeLodShapeTest {};

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

TEST_F(SoTeSeamlessPatchesTest, NoBackgroundWithinFromAnywhere) {
  const auto node = hillsNode(1024);
  expectNoBackgroundWithin(node.get(), 40, [&](int view) {
    node->precision = 1.0f + float(view % 4);
    node->pixelError = view % 8 == 7 ? 3.0f : 0.0f;
    node->geomorph = view % 3 == 2;
  });
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

TEST_F(SoTeSeamlessPatchesTest, CoinDrawsThePrimitivesOfClipmapsAlike) {
  const HillsPyramid pyramid(256);
  const auto node = pyramid.node(65);
  for (const bool stretched : {false, true})
    expectCoinDrawsAlike(node.get(), stretched, stretched ? "stretched" : "");
}

TEST_F(SoTeSeamlessPatchesTest, ClipmapsTwiceInOneScene) {
  const HillsPyramid pyramid(512);
  const int frames = expectTwiceInOneScene(pyramid.node(65, 1000, 20000).get());
  std::printf("twice in one scene: at rest after %d frames\n", frames);
}

TEST_F(SoTeSeamlessPatchesTest, NeighboursAreNotDamagedByClipmaps) {
  TeGlNeighbour neighbour(context());
  const HillsPyramid pyramid(256);
  const auto node = pyramid.node(65);
  expectStateStays(neighbour, node.get());
  expectConesLookAsAlone(node.get());
}

TEST_F(SoTeSeamlessPatchesTest, NothingIsLeftInOpenGl) {
  const HillsPyramid pyramid(256);
  expectNothingIsLeft(
      [&] { return TeNodePtr<SoTeLodShape>(pyramid.node(65).get()); }, &TeSeamlessObjects::live, 0,
      [](SoTeLodShape& node, SoNode*) { static_cast<SoTeSeamlessPatches&>(node).resolution = 128; });
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

TEST_F(SoTeSeamlessPatchesTest, TwoContextsTakeTurns) {
  const HillsPyramid pyramid(512);
  const auto node = pyramid.node(129);
  expectContextsTakeTurns(overview(node.get()).get(), 20, [](int) {});
}

TEST_F(SoTeSeamlessPatchesTest, ClipmapsWhileTheyLoad) {
  const HillsPyramid pyramid(1024);
  const auto node = pyramid.node(129, 1000, 3000); // some rows a frame
  node->precision = 6;
  const auto scene = seenBy(SbVec3f(-350, -350, 230), SbVec3f(100, 50, 60), node.get());
  addSun(scene.get());
  SceneChanges changes(scene.get());
  int frames = 0;
  std::int64_t faces = 0;
  std::int64_t mostBytes = 0;
  do {
    changes.count = 0;
    const TePicture picture = show(scene.get(), frames == 0 ? "loading" : "");
    EXPECT_EQ(enclosedBackground(picture), 0) << frames;
    EXPECT_GE(node->statistics().faces, faces / 2) << frames;
    faces = node->statistics().faces;
    if (frames > 0)
      mostBytes = std::max(mostBytes, node->statistics().bytesUploaded);
    SoDB::getSensorManager()->processDelayQueue(TRUE);
    frames++;
  } while (changes.count > 0 && frames < 1000);
  std::printf("clip windows loaded in %d frames, at most %lld bytes in one\n", frames,
              static_cast<long long>(mostBytes));
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 1000);
  EXPECT_LT(mostBytes, 200000);
  // At rest: nothing is chosen or uploaded again, and nobody asks for a frame.
  changes.count = 0;
  show(scene.get());
  SoDB::getSensorManager()->processDelayQueue(TRUE);
  EXPECT_EQ(changes.count, 0);
  EXPECT_EQ(node->statistics().selectionSeconds, 0);
}
