#include "nodes/terrain/SoTeStaticTerrain.h"

#include "nodes/readScene.h"
#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/topView.h"

namespace {
class SoTeStaticTerrainTest : public TeRenderTest {};
} // namespace

TEST_F(SoTeStaticTerrainTest, DrawsTheBlockOfItsFields) {
  const auto file = readScene("TeStaticTerrain { seed 7 }");
  ASSERT_TRUE(file);
  auto block = TeStaticBlock::build(worldOf(TeGeneratorRegistry::kDefaultGenerator, {}, 65, 7), {0, 0}, 3);
  ASSERT_TRUE(block) << block.error().message;
  const auto graph = teBlockGraph(*block);
  ASSERT_TRUE(graph) << graph.error().message;
  const SbVec3f light(1, 0.4f, -0.5f);
  const TePicture node = draw(topView(file.get(), 94, light).get(), 376, 376, "seed-7");
  const TePicture plain = draw(topView(graph->get(), 94, light).get(), 376, 376, "seed-7-plain");
  ASSERT_FALSE(node.rgba.empty());
  EXPECT_EQ(node, plain);
}

TEST_F(SoTeStaticTerrainTest, ChangedFieldsChangeThePicture) {
  const auto file = readScene("TeStaticTerrain { seed 7 samples 33 }");
  ASSERT_TRUE(file);
  const auto scene = topView(file.get(), 46);
  auto renderer = TeSceneRenderer::create(context(), 92, 92);
  ASSERT_TRUE(renderer) << renderer.error().message;
  TePicture before;
  for (int frame = 0; frame < 4; frame++) // caches settle
    before = *(*renderer)->render(scene.get());
  auto* terrain = static_cast<SoTeStaticTerrain*>(file->getChild(0));
  ASSERT_TRUE(terrain->isOfType(SoTeStaticTerrain::getClassTypeId()));
  terrain->seed = "8";
  const TePicture after = *(*renderer)->render(scene.get());
  EXPECT_NE(before, after);
  terrain->seed = "7";
  EXPECT_EQ(before, *(*renderer)->render(scene.get()));
}

TEST_F(SoTeStaticTerrainTest, TwoOfThemStandSideBySide) {
  const auto file = readScene("Separator { Separator { Translation { translation -24 0 0 } "
                              "TeStaticTerrain { samples 33 seed 1 } } "
                              "Separator { Translation { translation 24 0 0 } "
                              "TeStaticTerrain { samples 33 seed 2 } } }");
  ASSERT_TRUE(file);
  const TePicture picture = draw(topView(file.get(), 96).get(), 96, 96, "two");
  ASSERT_FALSE(picture.rgba.empty());
  const TePicture::Pixel magenta = {255, 0, 255, 255};
  EXPECT_NE(picture.pixel(24, 48), magenta);
  EXPECT_NE(picture.pixel(72, 48), magenta);
  EXPECT_EQ(picture.pixel(48, 48), magenta); // the strips that are not drawn
}
