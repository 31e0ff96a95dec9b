#include "nodes/terrain/TeBlockGraph.h"

#include "nodes/TeSceneFile.h"
#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/magenta.h"
#include "render/topView.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace {

class TeBlockGraphTest : public TeRenderTest {
protected:
  TeNodePtr<SoSeparator> graph(const TeStaticBlock& block, const TeBlockStyle& style = {}) {
    auto made = teBlockGraph(block, style);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    return *made;
  }
};

TeStaticBlock blockOf(TeWorld world, int patches = 3) {
  auto block = TeStaticBlock::build(std::move(world), {0, 0}, patches);
  EXPECT_TRUE(block) << (block ? "" : block.error().message);
  return std::move(*block);
}

} // namespace

// 94 of the block's 96 cells a side are drawn; 4 pixels a cell, and 8 all around.
TEST_F(TeBlockGraphTest, FillsExactlyItsRectangleFromAbove) {
  const TeStaticBlock block = blockOf(worldOf("faults", {}, 65, 3));
  const TePicture picture = draw(topView(graph(block).get(), 98).get(), 392, 392, "top");
  ASSERT_FALSE(picture.rgba.empty());
  int wrong = 0;
  for (int y = 0; y < 392; y++) {
    for (int x = 0; x < 392; x++) {
      const bool inside = x >= 8 && x < 384 && y >= 8 && y < 384;
      wrong += inside == (picture.pixel(x, y) == kMagenta);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST_F(TeBlockGraphTest, ShowsNoPixelBetweenPiecesFromAnySide) {
  const TeStaticBlock block = blockOf(worldOf("faults", {}, 65, 3));
  TeBlockStyle style;
  style.showParts = true;
  const auto terrain = graph(block, style);
  int pixels = 0;
  for (int view = 0; view < 12; view++) {
    const float around = float(view) * 0.5236f + 0.1f;
    const float up = 0.35f + 0.1f * float(view % 4);
    const SbVec3f from(std::cos(around) * std::cos(up), std::sin(around) * std::cos(up), std::sin(up));
    TeNodePtr<SoSeparator> scene(new SoSeparator);
    auto* camera = new SoPerspectiveCamera;
    camera->position = from * 160;
    camera->pointAt(SbVec3f(0, 0, 0), SbVec3f(0, 0, 1));
    scene->addChild(camera);
    auto* sun = new SoDirectionalLight;
    sun->direction.setValue(1, 0.3f, -0.6f);
    scene->addChild(sun);
    scene->addChild(terrain.get());
    const TePicture picture = draw(scene.get(), 500, 375, "view-" + std::to_string(view));
    ASSERT_FALSE(picture.rgba.empty());
    EXPECT_EQ(enclosedBackground(picture), 0) << "view " << view;
    const int drawn = 500 * 375 - countMagenta(picture);
    EXPECT_GT(drawn, 20000) << "view " << view;
    pixels += drawn;
  }
  std::printf("12 views: %d pixels of terrain, none of the background inside\n", pixels);
}

TEST_F(TeBlockGraphTest, DrawsNoCellWithAMissingCorner) {
  const auto missing = [](std::int64_t x, std::int64_t y) {
    const std::int64_t dx = x - 15;
    const std::int64_t dy = y - 9;
    return dx * dx + dy * dy < 60 || (x == 0 && y == 0) || (x == 32 && y == 16);
  };
  const auto source = std::make_shared<TeSampleFunction>([&](std::int64_t x, std::int64_t y) {
    return missing(x, y) ? std::nanf("") : float(std::sin(double(x) / 5) * 3 + double(y) / 9);
  });
  const TeStaticBlock block = blockOf(worldOf(source, 33));
  // Samples -16 .. 32, drawn from -15 to 31: 46 cells of 6 pixels.
  const TePicture picture = draw(topView(graph(block).get(), 46).get(), 276, 276, "missing");
  ASSERT_FALSE(picture.rgba.empty());
  int holes = 0;
  for (int row = 0; row < 46; row++) {
    for (int column = 0; column < 46; column++) {
      const std::int64_t x = column - 15;
      const std::int64_t y = row - 15;
      const bool hole = missing(x, y) || missing(x + 1, y) || missing(x, y + 1) || missing(x + 1, y + 1);
      holes += hole;
      for (int pixel = 0; pixel < 36; pixel++)
        ASSERT_EQ(picture.pixel(column * 6 + pixel % 6, row * 6 + pixel / 6) == kMagenta, hole)
            << column << " " << row;
    }
  }
  std::printf("%d cells with a missing corner are not drawn, %d others are\n", holes, 46 * 46 - holes);
}

TEST_F(TeBlockGraphTest, ColoursFollowHeight) {
  const auto ramp =
      std::make_shared<TeSampleFunction>([](std::int64_t x, std::int64_t) { return 0.01f * x; });
  const TeStaticBlock block = blockOf(worldOf(ramp, 65));
  const TePicture picture = draw(topView(graph(block).get(), 94).get(), 188, 188, "ramp");
  ASSERT_FALSE(picture.rgba.empty());
  const TePicture::Pixel low = picture.pixel(6, 94);
  const TePicture::Pixel middle = picture.pixel(128, 94);
  const TePicture::Pixel high = picture.pixel(182, 94);
  EXPECT_GT(low[1], low[0] + 20); // grass is green
  EXPECT_GT(low[1], low[2] + 20);
  EXPECT_LT(std::abs(middle[0] - middle[1]), 20); // rock is grey
  EXPECT_LT(middle[0], 140);
  EXPECT_GT(std::min({high[0], high[1], high[2]}), 200); // snow is white
}

TEST_F(TeBlockGraphTest, WaterCoversWhatIsBelow) {
  const auto ramp = std::make_shared<TeSampleFunction>([](std::int64_t x, std::int64_t) { return 0.1f * x; });
  const TeStaticBlock block = blockOf(worldOf(ramp, 65));
  TeBlockStyle style;
  style.water = 1.6f; // sample 16, the middle
  const TePicture wet = draw(topView(graph(block, style).get(), 94).get(), 188, 188, "water");
  const TePicture dry = draw(topView(graph(block).get(), 94).get(), 188, 188, "no-water");
  ASSERT_FALSE(wet.rgba.empty() || dry.rgba.empty());
  for (int x = 0; x < 188; x++) {
    if (std::abs(x - 94) < 2)
      continue;
    EXPECT_EQ(wet.pixel(x, 70) == dry.pixel(x, 70), x > 94) << x;
  }
  EXPECT_GT(wet.pixel(20, 70)[2], wet.pixel(20, 70)[0]);
}

TEST_F(TeBlockGraphTest, ImageLiesNorthUp) {
  const auto flat = std::make_shared<TeSampleFunction>([](std::int64_t, std::int64_t) { return 5.0f; });
  const TeStaticBlock block = blockOf(worldOf(flat, 65));
  TePicture image;
  image.width = image.height = 64;
  for (int y = 0; y < 64; y++) {
    for (int x = 0; x < 64; x++) {
      const std::uint8_t red = x < 32 ? 255 : 0;
      const std::uint8_t green = y < 32 ? 255 : 0;
      image.rgba.insert(image.rgba.end(), {red, green, 30, 255});
    }
  }
  TeBlockStyle style;
  style.image = image;
  const TePicture picture = draw(topView(graph(block, style).get(), 94).get(), 188, 188, "drape");
  ASSERT_FALSE(picture.rgba.empty());
  const auto isBright = [&](int x, int y, int channel) { return picture.pixel(x, y)[channel] > 120; };
  EXPECT_TRUE(isBright(40, 40, 0) && isBright(40, 40, 1));       // south-west
  EXPECT_TRUE(!isBright(150, 40, 0) && isBright(150, 40, 1));    // south-east
  EXPECT_TRUE(isBright(40, 150, 0) && !isBright(40, 150, 1));    // north-west
  EXPECT_TRUE(!isBright(150, 150, 0) && !isBright(150, 150, 1)); // north-east
  EXPECT_FALSE(isBright(96, 40, 0)); // the image's middle lies in the block's middle
  EXPECT_TRUE(isBright(91, 40, 0));
}

TEST_F(TeBlockGraphTest, RenderCachingChangesNoPixel) {
  const TeStaticBlock block = blockOf(worldOf("faults", {}, 33, 4));
  const auto terrain = graph(block);
  std::vector<TePicture> pictures;
  for (const SoSeparator::CacheEnabled caching : {SoSeparator::OFF, SoSeparator::ON, SoSeparator::AUTO}) {
    const auto scene = topView(terrain.get(), 46, SbVec3f(1, 0.4f, -0.5f));
    scene->renderCaching = caching;
    auto renderer = TeSceneRenderer::create(context(), 184, 184);
    ASSERT_TRUE(renderer) << renderer.error().message;
    for (int frame = 0; frame < 4; frame++) {
      TeResult<TePicture> picture = (*renderer)->render(scene.get());
      ASSERT_TRUE(picture) << picture.error().message;
      pictures.push_back(std::move(*picture));
    }
  }
  for (std::size_t i = 1; i < pictures.size(); i++)
    EXPECT_EQ(pictures[i], pictures[0]) << i;
}

// The same landscape around the origin and 10^14 m away from it.
TEST_F(TeBlockGraphTest, FarFromTheOriginIsTheSamePicture) {
  const auto waves = std::make_shared<TeSampleFunction>([](std::int64_t x, std::int64_t y) {
    return float((x & 15) * (y & 31)) * 0.03f - float((x ^ y) & 7) * 0.2f;
  });
  std::vector<TePicture> pictures;
  for (const double away : {0.0, 0x1p47}) {
    auto block = TeStaticBlock::build(worldOf(waves, 65), {away, -away}, 3);
    ASSERT_TRUE(block) << block.error().message;
    pictures.push_back(
        draw(topView(graph(*block).get(), 94, SbVec3f(1, 0.4f, -0.5f)).get(), 188, 188, "far"));
  }
  ASSERT_FALSE(pictures[0].rgba.empty());
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(TeBlockGraphTest, ExportedFileIsTheSamePicture) {
  const TeStaticBlock block = blockOf(worldOf("faults", {}, 33, 4));
  TeBlockStyle style;
  style.water = 0.0f;
  style.verticalScale = 0.5f;
  const auto terrain = graph(block, style);
  const std::string path = testing::TempDir() + "exported-" + context().name() + ".iv";
  ASSERT_TRUE(teWriteScene(terrain.get(), path));
  SoInput input;
  ASSERT_TRUE(input.openFile(path.c_str()));
  const TeNodePtr<SoSeparator> read(SoDB::readAll(&input));
  ASSERT_TRUE(read);
  std::filesystem::remove(path);
  const SbVec3f light(1, 0.4f, -0.5f);
  const TePicture before = draw(topView(terrain.get(), 46, light).get(), 184, 184, "before-export");
  const TePicture after = draw(topView(read.get(), 46, light).get(), 184, 184, "after-export");
  ASSERT_FALSE(before.rgba.empty());
  EXPECT_EQ(before, after);
}
