#include "nodes/context/TeViewer.h"

#include "render/TeRenderTest.h"
#include "nodes/testWorld.h"
#include "render/topView.h"

#include <algorithm>
#include <cstdio>

namespace {
class TeViewerTest : public TeRenderTest {};
} // namespace

TEST_F(TeViewerTest, WindowShowsWhatIsDrawnOffscreen) {
  if (TeRenderTest::s_kind != TeContextKind::Window)
    GTEST_SKIP() << "only with --context window";
  auto block = TeStaticBlock::build(worldOf("faults", {"matrix"}, 65, 3), {0, 0}, 3);
  ASSERT_TRUE(block) << block.error().message;
  const auto graph = teBlockGraph(*block);
  ASSERT_TRUE(graph) << graph.error().message;
  const auto scene = topView(graph->get(), 100, SbVec3f(1, 0.4f, -0.5f));
  TeViewerOptions options;
  options.width = 320;
  options.height = 320;
  options.background = SbColor(1, 0, 1);
  options.frames = 3;
  const TeResult<TeViewerSession> session = teRunViewer(scene.get(), options);
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_EQ(session->frames, 3);
  const TePicture& window = session->picture;
  ASSERT_EQ(window.width, 320);
  ASSERT_EQ(window.height, 320);
  const TePicture offscreen = draw(scene.get(), 320, 320, "offscreen");
  ASSERT_FALSE(offscreen.rgba.empty());
  int different = 0;
  for (std::size_t i = 0; i < offscreen.rgba.size(); i++)
    different += std::abs(int(offscreen.rgba[i]) - int(window.rgba[i])) > 2;
  std::printf("window and offscreen picture: %d of %zu values differ by more than 2\n", different,
              offscreen.rgba.size());
  EXPECT_LE(different, int(offscreen.rgba.size() / 200));
}

TEST_F(TeViewerTest, OneWindowAfterAnother) {
  if (TeRenderTest::s_kind != TeContextKind::Window)
    GTEST_SKIP() << "only with --context window";
  const auto flat = std::make_shared<TeSampleFunction>([](std::int64_t, std::int64_t) { return 5.0f; });
  auto block = TeStaticBlock::build(worldOf(flat, 9), {0, 0}, 3);
  ASSERT_TRUE(block) << block.error().message;
  const auto graph = teBlockGraph(*block);
  ASSERT_TRUE(graph) << graph.error().message;
  TeViewerOptions options;
  options.frames = 1;
  for (int side : {64, 100}) {
    options.width = options.height = side;
    const TeResult<TeViewerSession> session = teRunViewer(topView(graph->get(), 10).get(), options);
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->picture.width, side);
  }
}
