#include "nodes/terrain/SoTeTerrainMesh.h"

#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/meshScene.h"
#include "render/topView.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <cmath>

namespace {

constexpr TePicture::Pixel kMagenta = {255, 0, 255, 255};

TeStaticBlock blockOf(TeWorld world, glm::dvec2 centre = {0, 0}, int patches = 3) {
  auto block = TeStaticBlock::build(std::move(world), centre, patches);
  EXPECT_TRUE(block) << (block ? "" : block.error().message);
  return std::move(*block);
}

std::shared_ptr<TeMeshDrawing> drawingOf(const TeStaticBlock& block) {
  auto drawing = std::make_shared<TeMeshDrawing>(block.centre());
  drawing->setWorldOrigin({block.centre(), 0});
  return drawing;
}

/// A scene seen from one side and above, lit by the sun.
TeNodePtr<SoSeparator> sideView(SoNode* graph, float distance = 90) {
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoPerspectiveCamera;
  camera->position = SbVec3f(0.6f, -0.65f, 0.45f) * distance;
  camera->pointAt(SbVec3f(0, 0, 0), SbVec3f(0, 0, 1));
  scene->addChild(camera);
  auto* sun = new SoDirectionalLight;
  sun->direction.setValue(1, 0.3f, -0.6f);
  scene->addChild(sun);
  scene->addChild(graph);
  return scene;
}

class SoTeTerrainMeshTest : public TeRenderTest {};

} // namespace

// Normals of 16 bits against floats: one step of a channel.
TEST_F(SoTeTerrainMeshTest, DrawsThePictureOfCoinsOwnNodes) {
  const TeStaticBlock block = blockOf(worldOf("faults", {}, 65, 3));
  const auto drawing = drawingOf(block);
  const auto graph = meshGraph(block, drawing);
  const auto coins = teBlockGraph(block);
  ASSERT_TRUE(coins) << coins.error().message;
  const TePicture mesh = draw(sideView(graph.get()).get(), 400, 300, "mesh");
  const TePicture coin = draw(sideView(coins->get()).get(), 400, 300, "mesh-coin");
  ASSERT_FALSE(mesh.rgba.empty());
  const TePixelDifference difference = comparePixels(mesh, coin);
  std::printf("%d pixels differ, by %d at most\n", difference.pixels, difference.largest);
  EXPECT_LE(difference.largest, 1);
  EXPECT_NE(mesh.pixel(200, 150), kMagenta);
  EXPECT_EQ(drawing->frame().meshesDrawn, 9 + 12 + 4);
  EXPECT_EQ(drawing->frame().triangles, 2 * 94 * 94);
}
