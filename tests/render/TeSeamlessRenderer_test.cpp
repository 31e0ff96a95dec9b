#include "nodes/seamless/TeSeamlessRenderer.h"

#include "render/TeGlNeighbour.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"
#include "render/seamlessPyramid.h"
#include "render/seamlessScene.h"

#include <array>
#include <cstdio>
#include <cstring>

namespace {

class TeSeamlessRendererTest : public TeRenderTest {
protected:
  /// Before the scene: the drawing is freed in its context.
  std::unique_ptr<SeamlessScene> hills(TeSeamlessTechnique::Colours colours = TeSeamlessTechnique::Slope) {
    const TeSeamlessLayout layout = seamlessLayout(128, 4, 3);
    auto scene = std::make_unique<SeamlessScene>(layout, 1);
    scene->look.technique = {TeSeamlessTechnique::Heightmap, colours, true};
    scene->look.heights = hillyMap(128, 12);
    scene->look.slopes = TeSeamlessSlopeColours::forHeights(-14, 14);
    return scene;
  }
  /// Seen from one side and above; `before` stands before the terrain.
  TePicture show(SeamlessScene& scene, const std::string& name = "",
                 const std::vector<SoNode*>& before = {}) {
    const TePicture picture = showNode(scene.node.get(), name, before);
    EXPECT_EQ(scene.error, "");
    return picture;
  }
  TePicture showNode(SoNode* node, const std::string& name = "", const std::vector<SoNode*>& before = {}) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    for (SoNode* other : before)
      group->addChild(other);
    group->addChild(node);
    const auto scene = sideView(group.get(), 130);
    auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
    camera->nearDistance = 1;
    camera->farDistance = 1000;
    auto renderer = TeSceneRenderer::create(context(), 320, 240);
    EXPECT_TRUE(renderer);
    (*renderer)->setBackground(SbColor(1, 0, 1));
    (*renderer)->setFitClipPlanes(false);
    TeResult<TePicture> picture = (*renderer)->render(scene.get());
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    if (!s_folder.empty() && !name.empty()) {
      EXPECT_TRUE(picture->writePng(s_folder + "/" + name + ".png"));
    }
    return std::move(*picture);
  }
};

// A triangle as numbers that can be compared: samples and the bits of heights.
using Corners = std::array<std::array<std::int32_t, 3>, 3>;

std::array<std::int32_t, 3> corner(std::int32_t column, std::int32_t row, float height) {
  std::int32_t bits;
  std::memcpy(&bits, &height, sizeof bits);
  return {column, row, bits};
}

/// In one order whatever vertex comes first.
Corners turned(Corners triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

std::vector<Corners> drawnTriangles(const std::vector<TeSeamlessRenderer::DrawnVertex>& vertices) {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
    Corners triangle;
    for (std::size_t j = 0; j < 3; j++)
      triangle[j] = corner(vertices[i + j].column, vertices[i + j].row, vertices[i + j].height);
    triangles.push_back(turned(triangle));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Corners> meshTriangles(const SeamlessScene& scene, const TeSeamlessHeights& heights) {
  std::vector<TeSeamlessMesh::Triangle> mesh;
  for (const TeSeamlessPatch& patch : scene.selection.patches)
    TeSeamlessMesh::appendPatch(patch, scene.layout, *scene.parts, heights, mesh);
  std::vector<Corners> triangles;
  for (const TeSeamlessMesh::Triangle& t : mesh)
    triangles.push_back(
        turned({corner(t.a.column, t.a.row, t.a.height), corner(t.b.column, t.b.row, t.b.height),
                corner(t.c.column, t.c.row, t.c.height)}));
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

} // namespace

TEST_F(TeSeamlessRendererTest, DrawsAHeightMapWithoutHoles) {
  const auto scene = hills();
  scene->select(selectLevel(scene->layout, 1, variedDetail(scene->layout, true)));
  const TePicture picture = show(*scene, "seamless-hills");
  EXPECT_GT(320 * 240 - countMagenta(picture), 10000);
  EXPECT_EQ(enclosedBackground(picture), 0);
  EXPECT_GT(scene->counts.triangles, 1000);
}

// generatePrimitives, picking and error measuring see TeSeamlessMesh: it must be what is drawn.
TEST_F(TeSeamlessRendererTest, DrawsTheTrianglesOfTheMeshBitForBit) {
  for (const bool geomorph : {false, true}) {
    const auto scene = hills();
    scene->look.geomorph = geomorph;
    scene->selectAround(3, geomorph);
    scene->captures = true;
    show(*scene);
    EXPECT_GT(scene->captured.size(), 3000u);
    EXPECT_EQ(drawnTriangles(scene->captured),
              meshTriangles(*scene, SeamlessMapHeights(scene->look.heights)));
    for (const TeSeamlessRenderer::DrawnVertex& vertex : scene->captured)
      ASSERT_EQ(vertex.relative, scene->drawnFrame->relative(vertex.column, vertex.row, vertex.height));
  }
}

TEST_F(TeSeamlessRendererTest, DrawsTheClipmapsHeightsInEveryFormatBitForBit) {
  const auto map = hillyMap(256, 9000, 20000);
  for (const TeClipFormat format : {TeClipFormat::Short, TeClipFormat::Half, TeClipFormat::Float})
    for (const bool geomorph : {false, true}) {
      SeamlessPyramid pyramid(*map, 33, format);
      pyramid.update(context().id(), {110, 150});
      SeamlessScene scene(seamlessLayout(256, 4, 3), 1);
      scene.placement.heightScale = 1e-3;
      scene.look.technique = {TeSeamlessTechnique::Clipmaps, TeSeamlessTechnique::Slope, true};
      scene.look.geomorph = geomorph;
      scene.heightClipmap = &pyramid.clipmap;
      scene.selectAround(4, geomorph, &pyramid.clipmap.residency);
      scene.captures = true;
      show(scene);
      EXPECT_GT(scene.captured.size(), 3000u);
      EXPECT_EQ(drawnTriangles(scene.captured), meshTriangles(scene, SeamlessClipHeights(pyramid)));
      for (const TeSeamlessRenderer::DrawnVertex& vertex : scene.captured)
        ASSERT_EQ(vertex.relative, scene.drawnFrame->relative(vertex.column, vertex.row, vertex.height));
      ASSERT_TRUE(context().makeCurrent());
      pyramid.free();
    }
}
