#include "nodes/terrain/TeMeshBuffers.h"

#include "nodes/testWorld.h"
#include "render/TeGlNeighbour.h"
#include "render/TeRenderTest.h"
#include "render/magenta.h"
#include "render/meshScene.h"

#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include <vector>

namespace {

class TeMeshBuffersTest : public TeRenderTest {
protected:
  TeStaticBlock faults() { return meshBlock(worldOf("faults", {}, 33, 3)); }
};

} // namespace

TEST_F(TeMeshBuffersTest, LeavesOpenGlAsItFoundIt) {
  const TeStaticBlock block = faults();
  TeNodePtr<SoSeparator> terrain = meshGraph(block, drawingOf(block));
  TeGlNeighbour neighbour(context());
  TeNodePtr<SoSeparator> graph(new SoSeparator);
  graph->addChild(terrain->getChild(0));
  graph->addChild(terrain->getChild(1));
  for (int i = 2; i < terrain->getNumChildren(); i++) {
    graph->addChild(neighbour.before().get());
    graph->addChild(terrain->getChild(i));
    graph->addChild(neighbour.after().get());
  }
  const auto scene = sideView(graph.get());
  const TePicture first = draw(scene.get(), 160, 120, "mesh-state"); // with uploads
  EXPECT_EQ(draw(scene.get(), 160, 120), first);
  EXPECT_EQ(neighbour.looks, 2 * 25);
  EXPECT_EQ(neighbour.changes, 0);
  EXPECT_EQ(first, draw(sideView(terrain.get()).get(), 160, 120));
}

// A shape of Coin's own, drawn from its buffers and with its material, is the same before and after terrain.
TEST_F(TeMeshBuffersTest, NeighboursLookAsWithoutIt) {
  const TeStaticBlock block = faults();
  const auto shapes = [](float x) {
    auto* root = new SoSeparator;
    auto* translation = new SoTranslation;
    translation->translation.setValue(x, 0, 0);
    root->addChild(translation);
    auto* sphere = new SoSphere; // with the default material that came before
    sphere->radius = 6;
    root->addChild(sphere);
    auto* material = new SoMaterial;
    material->diffuseColor.setValue(0.9f, 0.3f, 0.1f);
    root->addChild(material);
    auto* away = new SoTranslation;
    away->translation.setValue(0, 14, 0);
    root->addChild(away);
    root->addChild(new SoCone);
    return root;
  };
  const auto hidden = drawingOf(block);
  TeNodePtr<SoSeparator> alone(new SoSeparator);
  TeNodePtr<SoSeparator> among(new SoSeparator);
  for (SoSeparator* root : {alone.get(), among.get()}) {
    root->addChild(shapes(-12));
    if (root == among.get()) {
      auto* aside = new SoSeparator;
      auto* translation = new SoTranslation;
      translation->translation.setValue(0, 0, -500); // out of view: only its traces could be seen
      aside->addChild(translation);
      aside->addChild(meshGraph(block, drawingOf(block)).get());
      auto* near = new SoSeparator;
      auto* scale = new SoTransform;
      scale->scaleFactor.setValue(1e-4f, 1e-4f, 1e-4f); // drawn, and hidden in the sphere
      scale->translation.setValue(-12, 0, 0);
      near->addChild(scale);
      near->addChild(meshGraph(block, hidden).get());
      root->addChild(aside);
      root->addChild(near);
    }
    root->addChild(shapes(12));
  }
  for (int frame = 0; frame < 3; frame++)
    EXPECT_EQ(draw(sideView(alone.get(), 60).get(), 160, 120),
              draw(sideView(among.get(), 60).get(), 160, 120));
  EXPECT_EQ(hidden->frame().meshesDrawn, 3 * 25);
}

TEST_F(TeMeshBuffersTest, RenderCachingChangesNoPixel) {
  const TeStaticBlock block = faults();
  std::vector<TePicture> pictures;
  for (const SoSeparator::CacheEnabled caching : {SoSeparator::OFF, SoSeparator::ON, SoSeparator::AUTO}) {
    const auto graph = meshGraph(block, drawingOf(block));
    graph->renderCaching = caching;
    const auto scene = sideView(graph.get());
    scene->renderCaching = caching;
    auto renderer = TeSceneRenderer::create(context(), 160, 120);
    ASSERT_TRUE(renderer) << renderer.error().message;
    for (int frame = 0; frame < 4; frame++) {
      TeResult<TePicture> picture = (*renderer)->render(scene.get());
      ASSERT_TRUE(picture) << picture.error().message;
      pictures.push_back(std::move(*picture));
    }
  }
  EXPECT_LT(countMagenta(pictures[0]), 160 * 120 - 2000);
  for (std::size_t i = 1; i < pictures.size(); i++)
    EXPECT_EQ(pictures[i], pictures[0]) << i;
}

TEST_F(TeMeshBuffersTest, IsDrawnInTwoContextsByTurns) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  auto graph = meshGraph(block, drawing);
  auto scene = sideView(graph.get());
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other) << other.error().message;
  auto first = TeSceneRenderer::create(context(), 160, 120);
  auto second = TeSceneRenderer::create(**other, 160, 120);
  ASSERT_TRUE(first && second);
  const TePicture picture = *(*first)->render(scene.get());
  const std::size_t once = drawing->bufferBytes();
  EXPECT_EQ(picture, *(*second)->render(scene.get()));
  EXPECT_EQ(drawing->bufferBytes(), 2 * once);
  EXPECT_EQ(picture, *(*first)->render(scene.get()));

  // The second context goes, and only its buffers with it.
  second->reset();
  other->reset();
  EXPECT_EQ(drawing->bufferBytes(), once);
  EXPECT_EQ(picture, *(*first)->render(scene.get()));
}

TEST_F(TeMeshBuffersTest, TwoRenderActionsOfOneContextShareItsBuffers) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  const auto scene = sideView(meshGraph(block, drawing).get());
  auto first = TeSceneRenderer::create(context(), 160, 120);
  auto second = TeSceneRenderer::create(context(), 160, 120);
  ASSERT_TRUE(first && second);
  const TePicture picture = *(*first)->render(scene.get());
  const std::size_t bytes = drawing->bufferBytes();
  EXPECT_EQ(picture, *(*second)->render(scene.get()));
  EXPECT_EQ(drawing->bufferBytes(), bytes);
}

TEST_F(TeMeshBuffersTest, DrawsOnlyWhatIsInViewAndUploadsTheRestToo) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  const auto scene = sideView(meshGraph(block, drawing).get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  camera->position.setValue(0, 0, 30);
  camera->pointAt(SbVec3f(30, 1, 0), SbVec3f(0, 0, 1)); // down to the east
  auto renderer = TeSceneRenderer::create(context(), 64, 48);
  ASSERT_TRUE(renderer);
  ASSERT_TRUE((*renderer)->draw(scene.get()));
  const TeMeshDrawing::Frame first = drawing->frame();
  EXPECT_EQ(first.meshesDrawn + first.meshesCulled, 25);
  EXPECT_GT(first.meshesDrawn, 4);
  EXPECT_GT(first.meshesCulled, 8);
  EXPECT_EQ(first.uploads, 25);
  EXPECT_EQ(first.bytesUploaded, std::int64_t(drawing->bufferBytes()));
  EXPECT_GT(first.uploadSeconds, 0);

  drawing->resetFrame();
  EXPECT_GT(drawing->secondsPerByte(), 0);
  EXPECT_LT(drawing->uploadSeconds(1000), drawing->uploadSeconds(1000000));
  EXPECT_GE(25 * drawing->uploadSeconds(std::size_t(first.bytesUploaded) / 25), 0.9 * first.uploadSeconds);
  camera->pointAt(SbVec3f(-30, 1, 0), SbVec3f(0, 0, 1));
  ASSERT_TRUE((*renderer)->draw(scene.get()));
  EXPECT_GT(drawing->frame().meshesDrawn, 4);
  EXPECT_EQ(drawing->frame().uploads, 0);
}

TEST_F(TeMeshBuffersTest, NothingOfItStaysBehind) {
  const TeStaticBlock block = faults();
  auto renderer = TeSceneRenderer::create(context(), 32, 24);
  ASSERT_TRUE(renderer);
  const auto drawing = drawingOf(block);
  auto graph = meshGraph(block, drawing);
  auto scene = sideView(graph.get());
  std::size_t most = 0;
  for (int round = 0; round < 20; round++) {
    ASSERT_TRUE((*renderer)->draw(scene.get()));
    most = std::max(most, drawing->bufferBytes());
    auto next = meshGraph(block, drawing);
    scene->replaceChild(graph.get(), next.get());
    graph = next;
  }
  std::size_t added = 0;
  for (int i = 2; i < graph->getNumChildren(); i++)
    added += static_cast<SoTeTerrainMesh*>(graph->getChild(i))->uploadBytes();
  EXPECT_GT(most, added);
  EXPECT_LT(most, 2 * added); // with shared indices
  scene->removeChild(graph.get());
  graph = TeNodePtr<SoSeparator>();
  EXPECT_GT(drawing->bufferBytes(), 0u);
  ASSERT_TRUE((*renderer)->draw(scene.get())); // the context is current again: its buffers go
  EXPECT_EQ(drawing->bufferBytes(), 0u);
}

TEST_F(TeMeshBuffersTest, OutlivesItsContextAndItsDrawingsOwner) {
  const TeStaticBlock block = faults();
  auto drawing = drawingOf(block);
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  auto graph = meshGraph(block, drawing);
  {
    auto renderer = TeSceneRenderer::create(**other, 32, 24);
    ASSERT_TRUE(renderer);
    ASSERT_TRUE((*renderer)->draw(sideView(graph.get()).get()));
    EXPECT_GT(drawing->bufferBytes(), 0u);
    graph->removeChild(graph->getNumChildren() - 1); // waits to be freed as the context goes
  }
  other->reset();
  EXPECT_EQ(drawing->bufferBytes(), 0u);
  drawing.reset();
  EXPECT_LT(countMagenta(draw(sideView(graph.get()).get(), 64, 48)), 64 * 48);
  graph = TeNodePtr<SoSeparator>(); // the nodes, and the drawing with them
  draw(sideView(new SoSeparator).get(), 8, 8);
}
