#include "nodes/TePatchGraphBuilder.h"

#include "nodes/TeSceneFile.h"
#include "nodes/askScene.h"
#include "nodes/gridMesh.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoPackedColor.h>
#include <Inventor/nodes/SoTextureCoordinate2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

float hills(double x, double y) { return float(20 * std::sin(x / 17) * std::cos(y / 13)); }

TeLattice lattice(int samples, double spacing) { return *TeLattice::create(samples, spacing); }

std::string fileText(const std::string& path) {
  std::ifstream file(path);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

} // namespace

TEST(TePatchGraphBuilder, DrawsEveryTriangleOfTheMesh) {
  const TeLattice grid = lattice(65, 1);
  const TePatchGraphBuilder builder({0, 0});
  const auto piece = builder.build(gridMesh(grid, 0, 0, 31, 29, hills));
  EXPECT_EQ(triangles(piece.get()), 2 * 30 * 28);
}

TEST(TePatchGraphBuilder, PlacesVerticesInTheWorld) {
  const TeLattice grid = lattice(9, 2.5);
  TePatchGraphBuilder builder({100, -50});
  builder.setWorldOrigin({90, -60, 3});
  const auto piece = builder.build(gridMesh(grid, 40, 40, 3, 3, [](double, double) { return 7.0f; }));
  SoGetBoundingBoxAction bounds(SbViewportRegion(10, 10));
  bounds.apply(piece.get());
  const SbBox3f box = bounds.getBoundingBox();
  EXPECT_NEAR(box.getMin()[0], grid.position(40) - 90, 1e-4);
  EXPECT_NEAR(box.getMax()[0], grid.position(42) - 90, 1e-4);
  EXPECT_NEAR(box.getMin()[1], grid.position(40) + 60, 1e-4);
  EXPECT_NEAR(box.getMax()[1], grid.position(42) + 60, 1e-4);
  EXPECT_NEAR(box.getMin()[2], 4, 1e-4);
}

// Pieces that meet must not show a pixel between them: same bits, same transformation.
TEST(TePatchGraphBuilder, SharedVerticesAreTheSameBits) {
  for (const double spacing : {0.1, 1.0, 0.3333333, 92.7}) {
    for (const std::int64_t first : {std::int64_t(0), std::int64_t(-977), std::int64_t(1) << 40}) {
      const TeLattice grid = lattice(65, spacing);
      const TePatchGraphBuilder builder({grid.position(first + 20), grid.position(7)});
      const auto left = builder.build(gridMesh(grid, first, 0, 31, 31, hills));
      const auto right = builder.build(gridMesh(grid, first + 30, 0, 3, 31, hills));
      const SbVec3f* a = firstOf<SoCoordinate3>(left.get())->point.getValues(0);
      const SbVec3f* b = firstOf<SoCoordinate3>(right.get())->point.getValues(0);
      for (int row = 0; row < 31; row++)
        EXPECT_EQ(std::memcmp(&a[row * 31 + 30], &b[row * 3], sizeof(SbVec3f)), 0) << spacing << " " << row;
      EXPECT_EQ(left->getChild(0), right->getChild(0));
      EXPECT_TRUE(left->getChild(0)->isOfType(SoTranslation::getClassTypeId()));
    }
  }
}

TEST(TePatchGraphBuilder, WrittenPiecesReadBackTheSame) {
  const TeLattice grid = lattice(9, 0.7);
  TePatchGraphBuilder builder({0.3, 0.2});
  const auto piece = builder.build(gridMesh(grid, 3, 5, 5, 4, hills));
  const std::string path = testing::TempDir() + "piece.iv";
  const std::string again = testing::TempDir() + "again.iv";
  ASSERT_TRUE(teWriteScene(piece.get(), path));
  EXPECT_EQ(fileText(path).find("Te"), std::string::npos); // nothing but Coin's own nodes
  SoInput input;
  ASSERT_TRUE(input.openFile(path.c_str()));
  TeNodePtr<SoSeparator> read(SoDB::readAll(&input));
  ASSERT_TRUE(read);
  EXPECT_EQ(triangles(read.get()), triangles(piece.get()));
  const SoMFVec3f& a = firstOf<SoCoordinate3>(piece.get())->point;
  const SoMFVec3f& b = firstOf<SoCoordinate3>(read.get())->point;
  EXPECT_TRUE(a == b);
  ASSERT_TRUE(teWriteScene(read.get(), again));
  EXPECT_EQ(fileText(path), fileText(again));
  std::filesystem::remove(path);
  std::filesystem::remove(again);
}

TEST(TePatchGraphBuilder, FailingWritesNameTheFile) {
  const TeLattice grid = lattice(9, 1);
  const TePatchGraphBuilder builder({0, 0});
  const auto piece = builder.build(gridMesh(grid, 0, 0, 9, 9, hills));
  for (const char* path : {"/nonexistent/folder/a.iv", "/dev/full"}) {
    const TeStatus status = teWriteScene(piece.get(), path);
    ASSERT_FALSE(status) << path;
    EXPECT_NE(status.error().message.find(path), std::string::npos) << status.error().message;
  }
}

TEST(TePatchGraphBuilder, ColoursOutOfRangeAreLimited) {
  const TeLattice grid = lattice(9, 1);
  TePatchGraphBuilder builder({0, 0});
  TeSurfaceColours colours;
  colours.grass = {2.0f, -1.0f, std::nanf("")};
  builder.setColours(colours);
  const auto piece = builder.build(gridMesh(grid, 0, 0, 3, 3, [](double, double) { return -100.0f; }));
  const SoMFUInt32& packed = firstOf<SoPackedColor>(piece.get())->orderedRGBA;
  ASSERT_EQ(packed.getNum(), 9);
  for (int i = 0; i < 9; i++)
    EXPECT_EQ(packed[i], 0xFF0000FFu);
}

TEST(TePatchGraphBuilder, PartsHaveColoursOfTheirOwn) {
  const TeLattice grid = lattice(9, 1);
  TePatchGraphBuilder builder({0, 0});
  builder.setShowParts(true);
  TePatchMesh mesh = gridMesh(grid, 0, 0, 3, 3, hills);
  std::vector<SbColor> colours;
  for (TeSurfacePart part : {TeSurfacePart::Patch, TeSurfacePart::Seam, TeSurfacePart::Corner}) {
    mesh.part = part;
    colours.push_back(firstOf<SoBaseColor>(builder.build(mesh).get())->rgb[0]);
  }
  EXPECT_NE(colours[0], colours[1]);
  EXPECT_NE(colours[1], colours[2]);
  EXPECT_NE(colours[0], colours[2]);
}

TEST(TePatchGraphBuilder, ImageSpansItsRectangle) {
  const TeLattice grid = lattice(9, 1);
  TePatchGraphBuilder builder({0, 0});
  TePicture image;
  image.width = image.height = 2;
  image.rgba.assign(16, 200);
  const TeWorldRect rect = {{grid.position(0), grid.position(0)}, {grid.position(4), grid.position(8)}};
  ASSERT_TRUE(builder.setImage(image, rect));
  const auto piece = builder.build(gridMesh(grid, 0, 0, 5, 5, hills));
  const SoMFVec2f& st = firstOf<SoTextureCoordinate2>(piece.get())->point;
  EXPECT_EQ(st[0], SbVec2f(0, 0));
  EXPECT_EQ(st[24], SbVec2f(1, 0.5f));
  EXPECT_TRUE(firstOf<SoTexture2>(piece.get()));
  EXPECT_FALSE(firstOf<SoPackedColor>(piece.get()));

  EXPECT_FALSE(builder.setImage(TePicture(), rect));
  EXPECT_FALSE(builder.setImage(image, {rect.northEast, rect.southWest}));
}

TEST(TePatchGraphBuilder, WaterIsLevel) {
  const TePatchGraphBuilder builder({10, 20});
  const auto sheet = builder.water({{0, 0}, {30, 60}}, 5);
  SoGetBoundingBoxAction bounds(SbViewportRegion(10, 10));
  bounds.apply(sheet.get());
  const SbBox3f box = bounds.getBoundingBox();
  EXPECT_EQ(box.getMin()[2], 5);
  EXPECT_EQ(box.getMax()[2], 5);
  EXPECT_EQ(box.getMax()[1], 40);
}
