#include "nodes/terrain/TeMeshDrawing.h"

#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"

#include <cmath>
#include <cstdio>

namespace {

/// A block somewhere in the world, drawn around its centre.
class TeMeshDrawingTest : public TeRenderTest {
protected:
  void build(double away, int patches = 3) {
    m_block = std::make_unique<TeStaticBlock>(
        meshBlock(worldOf(std::make_shared<TeSampleFunction>(hills), 33), {away, -away}, patches));
    m_drawing = drawingOf(*m_block);
    m_graph = meshGraph(*m_block, m_drawing);
    m_scene = sideView(m_graph.get(), 70);
    auto renderer = TeSceneRenderer::create(context(), 320, 240);
    ASSERT_TRUE(renderer) << renderer.error().message;
    m_renderer = std::move(*renderer);
    m_renderer->setBackground(SbColor(1, 0, 1));
  }

  TePicture frame(std::size_t anchorBytes) {
    m_drawing->resetFrame(anchorBytes);
    TeResult<TePicture> picture = m_renderer->render(m_scene.get());
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    return std::move(*picture);
  }

  static float hills(std::int64_t x, std::int64_t y) {
    return float(3 * std::sin(double(x) * 0.2) + 2 * std::cos(double(y) * 0.3));
  }

  std::unique_ptr<TeStaticBlock> m_block;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  TeNodePtr<SoSeparator> m_graph;
  TeNodePtr<SoSeparator> m_scene;
  std::unique_ptr<TeSceneRenderer> m_renderer;
};

constexpr std::size_t kPatchBytes = 15 * 15 * 12; ///< positions of a patch's inside at W = 33

} // namespace

// Wherever in the world: no frame shows a gap, no frame uploads more than its allowance and one mesh, and the
// picture stays the same but for the rounding of positions.
TEST_F(TeMeshDrawingTest, ChangesTheAnchorBitByBitWithoutAGap) {
  for (const double away : {0.0, 1e6, 1e9}) {
    ASSERT_NO_FATAL_FAILURE(build(away));
    const TePicture before = frame(0);
    ASSERT_EQ(enclosedBackground(before), 0);
    const std::size_t bytes = m_drawing->bufferBytes();
    const glm::dvec2 from = m_drawing->anchor();
    m_drawing->beginAnchor(from + glm::dvec2(3000, 1800));
    int frames = 0;
    while (!m_drawing->nextAnchorReady() && frames < 100) {
      EXPECT_EQ(frame(2 * kPatchBytes), before); // still drawn from the buffers of the present anchor
      EXPECT_LT(m_drawing->frame().bytesUploaded, std::int64_t(3 * kPatchBytes));
      frames++;
    }
    EXPECT_GT(frames, 4);
    EXPECT_LT(frames, 100);
    EXPECT_EQ(m_drawing->anchor(), from);

    m_drawing->commitAnchor();
    EXPECT_FALSE(m_drawing->changesAnchor());
    EXPECT_EQ(m_drawing->anchor(), from + glm::dvec2(3000, 1800));
    const TePicture after = frame(0);
    EXPECT_EQ(m_drawing->frame().uploads, 0);
    EXPECT_EQ(m_drawing->bufferBytes(), bytes);
    EXPECT_EQ(enclosedBackground(after), 0);
    const TePixelDifference difference = comparePixels(before, after);
    std::printf("%g m away: %d frames; %d of %d pixels differ after it\n", away, frames, difference.pixels,
                320 * 240 - countMagenta(before));
    EXPECT_LT(difference.pixels, (320 * 240 - countMagenta(before)) / 50);
    EXPECT_EQ(frame(0), after);
  }
}

TEST_F(TeMeshDrawingTest, UploadsNothingForTheNextAnchorWithoutAnAllowance) {
  ASSERT_NO_FATAL_FAILURE(build(0));
  frame(0);
  m_drawing->beginAnchor({64, 64});
  for (int i = 0; i < 3; i++) {
    frame(0);
    EXPECT_EQ(m_drawing->frame().uploads, 0);
    EXPECT_FALSE(m_drawing->nextAnchorReady());
  }
  frame(1); // one mesh at least
  EXPECT_EQ(m_drawing->frame().uploads, 1);
}

// The patches of a block come one by one while the anchor changes.
TEST_F(TeMeshDrawingTest, MeshesThatComeDuringAChangeTakePartInIt) {
  ASSERT_NO_FATAL_FAILURE(build(1e6));
  const TePicture whole = frame(0);
  std::vector<TeNodePtr<SoNode>> late;
  for (int i = 0; i < 10; i++) {
    late.emplace_back(m_graph->getChild(m_graph->getNumChildren() - 1));
    m_graph->removeChild(m_graph->getNumChildren() - 1);
  }
  m_drawing->beginAnchor(m_drawing->anchor() + glm::dvec2(-256, 512));
  int frames = 0;
  while ((!late.empty() || !m_drawing->nextAnchorReady()) && frames < 100) {
    if (!late.empty()) {
      m_graph->addChild(late.back().get());
      late.pop_back();
    }
    frame(kPatchBytes);
    frames++;
  }
  ASSERT_LT(frames, 100);
  m_drawing->commitAnchor();
  const TePicture after = frame(0);
  EXPECT_EQ(m_drawing->frame().uploads, 0);
  EXPECT_EQ(enclosedBackground(after), 0);
  EXPECT_LT(comparePixels(whole, after).pixels, 500);
}

TEST_F(TeMeshDrawingTest, CommittedBeforeItIsReadyIsStillWithoutAGap) {
  ASSERT_NO_FATAL_FAILURE(build(1e9));
  frame(0);
  m_drawing->beginAnchor(m_drawing->anchor() + glm::dvec2(512, 512));
  frame(kPatchBytes);
  EXPECT_FALSE(m_drawing->nextAnchorReady());
  m_drawing->commitAnchor();
  const TePicture after = frame(0);
  EXPECT_EQ(m_drawing->frame().uploads, 25 - 1);
  EXPECT_EQ(enclosedBackground(after), 0);
}

// 81 meshes: freeing all their buffers in one frame would be felt.
TEST_F(TeMeshDrawingTest, BuffersOfTheAnchorBeforeGoBitByBit) {
  ASSERT_NO_FATAL_FAILURE(build(0, 5));
  frame(0);
  const std::size_t bytes = m_drawing->bufferBytes();
  m_drawing->beginAnchor({640, 0});
  const TePicture there = frame(1 << 20);
  ASSERT_TRUE(m_drawing->nextAnchorReady());
  const std::size_t both = m_drawing->bufferBytes();
  m_drawing->commitAnchor();
  frame(0);
  EXPECT_LT(m_drawing->bufferBytes(), both);
  EXPECT_GT(m_drawing->bufferBytes(), bytes);
  frame(0);
  EXPECT_EQ(m_drawing->bufferBytes(), bytes);

  // Back again before they are gone: they are used again.
  m_drawing->beginAnchor({0, 0});
  frame(1 << 20);
  m_drawing->commitAnchor();
  m_drawing->beginAnchor({640, 0});
  EXPECT_EQ(frame(1 << 20), there);
  EXPECT_EQ(m_drawing->frame().uploads, 0);
  EXPECT_TRUE(m_drawing->nextAnchorReady());
}

TEST_F(TeMeshDrawingTest, AnotherNextAnchorStartsTheChangeOver) {
  ASSERT_NO_FATAL_FAILURE(build(0));
  const TePicture before = frame(0);
  const std::size_t bytes = m_drawing->bufferBytes();
  m_drawing->beginAnchor({512, 0});
  frame(1 << 20);
  EXPECT_TRUE(m_drawing->nextAnchorReady());
  m_drawing->beginAnchor({0, 256});
  EXPECT_FALSE(m_drawing->nextAnchorReady());
  frame(1 << 20);
  EXPECT_TRUE(m_drawing->nextAnchorReady());
  m_drawing->commitAnchor();
  EXPECT_EQ(m_drawing->anchor(), glm::dvec2(0, 256));
  EXPECT_LT(comparePixels(before, frame(0)).pixels, 500);
  EXPECT_EQ(m_drawing->bufferBytes(), bytes);
}

TEST_F(TeMeshDrawingTest, AnAnchorSetAtOnceMovesAllMeshes) {
  ASSERT_NO_FATAL_FAILURE(build(1e6));
  const TePicture before = frame(0);
  const std::size_t bytes = m_drawing->bufferBytes();
  m_drawing->beginAnchor({0, 0});
  frame(kPatchBytes);
  m_drawing->setAnchor(m_drawing->anchor() + glm::dvec2(128, 64));
  EXPECT_FALSE(m_drawing->changesAnchor());
  const TePicture after = frame(0);
  EXPECT_EQ(m_drawing->frame().uploads, 25);
  EXPECT_EQ(m_drawing->bufferBytes(), bytes); // nothing is left of the change that was broken off
  EXPECT_EQ(enclosedBackground(after), 0);
  EXPECT_LT(comparePixels(before, after).pixels, 500);
}

// A second window that is not drawn must not hold up a change, nor be wrong after it.
TEST_F(TeMeshDrawingTest, AContextThatIsNotDrawnCatchesUpLater) {
  ASSERT_NO_FATAL_FAILURE(build(1e6));
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  auto hidden = TeSceneRenderer::create(**other, 320, 240);
  ASSERT_TRUE(hidden);
  (*hidden)->setBackground(SbColor(1, 0, 1));
  EXPECT_EQ(*(*hidden)->render(m_scene.get()), frame(0));
  m_drawing->beginAnchor(m_drawing->anchor() + glm::dvec2(640, 0));
  frame(1 << 20);
  ASSERT_TRUE(m_drawing->nextAnchorReady());
  m_drawing->commitAnchor();
  const TePicture shown = frame(0);
  EXPECT_EQ(*(*hidden)->render(m_scene.get()), shown);
  m_drawing->resetFrame();
  hidden->reset(); // before its context
}
