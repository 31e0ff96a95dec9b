// The code of docs/clipmaps.md, compiled and run.

#include "nodes/TeNodes.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/clipmap/TeClipWindows.h"
#include "nodes/clipmap/TeClipmapTexture.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace {

//! [windows]
TeResult<std::unique_ptr<TeClipWindows>> openWindows(const std::string& name) {
  constexpr int kSize = 513;
  TeResult<TePyramidReader> reader = TePyramidReader::open(name, 2, TeClipWindows::wholeLevel(kSize));
  if (!reader)
    return reader.error();
  const auto tiles = std::make_shared<TePyramidTiles>(std::move(*reader), 16 << 20);
  return TeClipWindows::create(tiles, kSize);
}
//! [windows]

//! [frame]
TeStatus drawFrame(TeClipWindows& windows, TeClipmapTexture& texture, glm::dvec2 eye) {
  windows.update(eye, 14, 1 << 20); // in samples of level 14, a megabyte at most
  if (TeStatus status = texture.update(windows); !status)
    return status;
  // windows.residency() tells what may be drawn from texture.name().
  return {};
}
//! [frame]

TEST(DocsClipmaps, WindowsOverAPyramid) {
  const std::string folder = testing::TempDir() + "docs-clipmaps-" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  for (int level = 0; level <= 10; level++) {
    std::ofstream(tePyramidLevelFile(folder + "/ps_height", level)).close();
    std::filesystem::resize_file(tePyramidLevelFile(folder + "/ps_height", level),
                                 TePyramidReader::levelBytes(level, 2));
  }
  const auto windows = openWindows(folder + "/ps_height");
  ASSERT_TRUE(windows) << windows.error().message;
  EXPECT_EQ((*windows)->levels(), 2);
  (*windows)->update({8192, 8192}, 14, 1 << 20);
  EXPECT_TRUE((*windows)->isSettled());
  EXPECT_EQ((*windows)->height(10, 512, 512), 0);
  EXPECT_NE(&drawFrame, nullptr); // needs a context; tests/render/TeClipmapTexture_test.cpp has one
  std::filesystem::remove_all(folder);

  EXPECT_FALSE(openWindows(folder + "/ps_height"));
}

} // namespace
