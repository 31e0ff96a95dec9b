// Examples of docs/seamless-patches.md.

#include "nodes/TeNodePtr.h"
#include "nodes/TeNodes.h"
#include "nodes/TePicture.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/clipmap/TePyramidFiles.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace {

/// In the current folder: level files puget_0.raw .. puget_12.raw of a dome, and puget.png.
class Data {
public:
  Data() {
    std::filesystem::create_directories(m_folder);
    std::filesystem::current_path(m_folder);
    const int top = 12;
    for (int level = 0; level <= top; level++) {
      const int side = tePyramidSide(level);
      std::string bytes;
      for (int y = 0; y < side; y++) {
        for (int x = 0; x < side; x++) {
          const int east = x << (top - level), north = y << (top - level);
          const int height = (east * (4096 - east) / 256 + north * (4096 - north) / 256) / 4;
          bytes.push_back(char(height & 255));
          bytes.push_back(char(height >> 8));
        }
      }
      std::ofstream(tePyramidLevelFile("puget", level), std::ios::binary) << bytes;
    }
    TePicture picture;
    picture.width = picture.height = 2;
    picture.rgba.assign(16, 200);
    EXPECT_TRUE(picture.writePng("puget.png"));
  }
  ~Data() {
    std::filesystem::current_path(m_before);
    std::filesystem::remove_all(m_folder);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

private:
  std::filesystem::path m_before = std::filesystem::current_path();
  std::filesystem::path m_folder =
      std::filesystem::temp_directory_path() / ("terrane-docs-seamless-" + std::to_string(::getpid()));
};

int triangles(SoNode* node) {
  SoGetPrimitiveCountAction count;
  count.apply(node);
  return count.getTriangleCount();
}

const char* const kScene = R"iv(#Inventor V2.1 ascii
//! [scene]
TeSeamlessPatches {
  size 256 256 10
  resolution 4096
  minPatchResolution 16
  levels 3
  heightSource CLIPMAPS
  heights TeClipmap { name "puget" size 513 }
  coloring TEXTURE
  texture "puget.png"
  instancing TRUE
  precision 2
}
//! [scene]
)iv";

/// Without the lines that mark it in this file.
std::string sceneText() {
  std::string text = kScene;
  const std::string marker = "//! [scene]\n";
  for (std::size_t at = text.find(marker); at != std::string::npos; at = text.find(marker))
    text.erase(at, marker.size());
  return text;
}

} // namespace

TEST(DocsSeamless, SetUp) {
  const Data data;
  TeNodes::init();
  TeNodePtr<SoSeparator> root(new SoSeparator);
  //! [setup]
  auto* clipmap = new SoTeClipmap;
  clipmap->name = "puget"; // puget_0.raw .. puget_12.raw, made by terrane-bake mipmaps
  clipmap->size = 513;

  auto* terrain = new SoTeSeamlessPatches;
  terrain->size.setValue(256, 256, 10);
  terrain->resolution = 4096;
  terrain->minPatchResolution = 16;
  terrain->levels = 3;
  terrain->heightSource = SoTeSeamlessPatches::CLIPMAPS;
  terrain->heights = clipmap;
  terrain->coloring = SoTeSeamlessPatches::TEXTURE;
  terrain->texture = "puget.png";
  terrain->instancing = TRUE;
  terrain->precision = 2;
  root->addChild(terrain);
  //! [setup]
  EXPECT_EQ(terrain->getError(), "");
  EXPECT_GT(triangles(root.get()), 10000);

  const std::string text = sceneText();
  SoInput input;
  input.setBuffer(text.data(), text.size());
  TeNodePtr<SoSeparator> read(SoDB::readAll(&input));
  ASSERT_TRUE(read);
  EXPECT_EQ(triangles(read.get()), triangles(root.get()));
}

TEST(DocsSeamless, HeightsInMemory) {
  TeNodes::init();
  //! [memory]
  TeResult<TeHeightMap> map = TeHeightMap::create(1025, 1025); // 2^n + 1 samples a side
  ASSERT_TRUE(map);
  for (int row = 0; row < 1025; row++)
    for (int column = 0; column < 1025; column++)
      map->at(column, row) = 0.001f * float(row * (1024 - row)); // metres; row 0 in the south

  TeNodePtr<SoTeSeamlessPatches> terrain(new SoTeSeamlessPatches);
  terrain->size.setValue(10240, 10240, 0); // metres
  terrain->resolution = 0;                 // as many cells as the map has
  terrain->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  terrain->setHeights(std::make_shared<const TeHeightMap>(std::move(*map)));
  terrain->pixelError = 2; // in place of precision
  terrain->coloring = SoTeSeamlessPatches::HEIGHT;
  if (!terrain->getError().empty())
    std::fprintf(stderr, "no terrain: %s\n", terrain->getError().c_str());
  //! [memory]
  EXPECT_EQ(terrain->getError(), "");
  EXPECT_GT(triangles(terrain.get()), 0);
}
