#include "render/TeRenderTest.h"

#include "nodes/TeNodes.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

TeContextKind TeRenderTest::s_kind = TeContextKind::Egl;
std::string TeRenderTest::s_folder;

void TeRenderTest::SetUp() {
  auto context = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(context) << context.error().message;
  m_context = std::move(*context);
}

TePicture TeRenderTest::draw(SoNode* scene, int width, int height, const std::string& name,
                             const SbColor& background) {
  auto renderer = TeSceneRenderer::create(context(), width, height);
  if (!renderer) {
    ADD_FAILURE() << renderer.error().message;
    return {};
  }
  (*renderer)->setBackground(background);
  TeResult<TePicture> picture = (*renderer)->render(scene);
  if (!picture) {
    ADD_FAILURE() << picture.error().message;
    return {};
  }
  if (!s_folder.empty() && !name.empty()) {
    const TeStatus status = picture->writePng(s_folder + "/" + name + ".png");
    EXPECT_TRUE(status) << status.error().message;
  }
  return std::move(*picture);
}

// render_test --context egl|osmesa|window [--pictures FOLDER] [GoogleTest's options]
extern "C" int teMain(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--context") {
      const TeResult<TeContextKind> kind = teContextKind(argv[i + 1]);
      if (!kind) {
        std::fprintf(stderr, "render_test: %s\n", kind.error().message.c_str());
        return 2;
      }
      TeRenderTest::s_kind = *kind;
    } else if (option == "--pictures") {
      TeRenderTest::s_folder = argv[i + 1];
    }
  }
  TeNodes::init();
  if (!TeRenderTest::s_folder.empty()) {
    std::filesystem::create_directories(TeRenderTest::s_folder);
    if (const auto context = TeContext::create(TeRenderTest::s_kind, 8, 8))
      std::ofstream(TeRenderTest::s_folder + "/renderer.txt") << (*context)->renderer() << "\n";
  }
  return RUN_ALL_TESTS();
}
