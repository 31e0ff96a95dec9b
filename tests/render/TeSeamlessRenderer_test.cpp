#include "nodes/seamless/TeSeamlessRenderer.h"

#include "render/SeamlessRenderTest.h"
#include "render/seamlessPyramid.h"

#include <Inventor/nodes/SoMaterial.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <set>

namespace {

using TeSeamlessRendererTest = SeamlessRenderTest;

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
  for (const bool wholePatches : {false, true})
    for (const bool geomorph : {false, true}) {
      const auto scene = hills(TeSeamlessTechnique::Slope, wholePatches);
      EXPECT_EQ(scene->parts->hasWholePatches(), wholePatches);
      scene->look.geomorph = geomorph;
      scene->selectAround(3, geomorph);
      scene->captures = true;
      show(*scene);
      EXPECT_GT(scene->captured.size(), 3000u);
      int moved = 0;
      for (const TeSeamlessRenderer::DrawnVertex& vertex : scene->captured)
        moved += vertex.height != scene->look.heights->at(vertex.column, vertex.row);
      EXPECT_EQ(moved > 100, geomorph);
      EXPECT_EQ(drawnTriangles(scene->captured),
                meshTriangles(*scene, TeSeamlessMapHeights(scene->look.heights.get())));
      for (const TeSeamlessRenderer::DrawnVertex& vertex : scene->captured)
        ASSERT_EQ(vertex.relative, scene->drawnFrame->relative(vertex.column, vertex.row, vertex.height));
    }
}

TEST_F(TeSeamlessRendererTest, DrawsTheLargestPatchOfTheLargestTerrain) {
  SeamlessScene scene(seamlessLayout(TeSeamlessLayout::kMaxResolution, 128, 3), 0);
  scene.captures = true;
  show(scene);
  EXPECT_EQ(scene.captured.size(), std::size_t(scene.selection.patches.size() * 128 * 128 * 2 * 3));
  EXPECT_EQ(drawnTriangles(scene.captured), meshTriangles(scene, TeSeamlessMapHeights(nullptr)));
  for (const TeSeamlessRenderer::DrawnVertex& vertex : scene.captured) {
    ASSERT_GE(std::min(vertex.column, vertex.row), 0);
    ASSERT_LE(std::max(vertex.column, vertex.row), TeSeamlessLayout::kMaxResolution);
  }
}

TEST_F(TeSeamlessRendererTest, DrawsTheClipmapsHeightsInEveryFormatBitForBit) {
  const auto map = hillyMap(256, 9000, 20000);
  for (const TeClipFormat format : {TeClipFormat::Short, TeClipFormat::Half, TeClipFormat::Float})
    for (const int way : {0, 1, 2, 3}) {
      const bool geomorph = way & 1;
      const bool wholePatches = way & 2;
      SeamlessPyramid pyramid(*map, 33, format);
      pyramid.update(context().id(), {110, 150});
      SeamlessScene scene(seamlessLayout(256, 4, 3), 1, wholePatches);
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

TEST_F(TeSeamlessRendererTest, WholePatchesAreThePictureOfTheirPartsInFewerInstances) {
  const auto parts = hills();
  const auto patches = hills(TeSeamlessTechnique::Slope, true);
  for (const bool instanced : {true, false}) {
    for (const auto& scene : {parts.get(), patches.get()}) {
      scene->selectAround(3, false);
      scene->look.technique.instanced = instanced;
    }
    EXPECT_EQ(show(*parts), show(*patches));
    EXPECT_EQ(parts->counts.triangles, patches->counts.triangles);
    EXPECT_EQ(parts->counts.instances, 8 * patches->counts.instances);
  }
}

// The document's combinations and those with colours by height and slope.
TEST_F(TeSeamlessRendererTest, EveryTechniqueDrawsAndIsCompiledOnlyWhenItIsUsed) {
  const auto map = hillyMap(128, 12, 20);
  SeamlessPyramid pyramid(*map, 33, TeClipFormat::Short);
  pyramid.update(context().id(), {60, 70});
  SeamlessScene scene(seamlessLayout(128, 4, 3), 1);
  scene.selectAround(3, false, &pyramid.clipmap.residency);
  scene.heightClipmap = &pyramid.clipmap;
  scene.look.heights = map;
  scene.look.texture = picture(64, [](int x, int y) {
    return TePicture::Pixel{std::uint8_t(4 * x), std::uint8_t(4 * y), 90, 255};
  });
  scene.look.mask = picture(16, [](int x, int y) {
    return TePicture::Pixel{std::uint8_t(16 * x), std::uint8_t(16 * y), 60, 0};
  });
  scene.look.details = {plainPicture(200, 60, 60), plainPicture(60, 200, 60), plainPicture(60, 60, 200),
                        plainPicture(0, 0, 0)};
  scene.look.slopes = TeSeamlessSlopeColours::forHeights(4, 36);
  std::set<std::pair<int, int>> drawn; // classic and instanced share a program
  std::vector<TePicture> pictures;
  for (const TeSeamlessTechnique& technique : TeSeamlessTechnique::all()) {
    scene.look.technique = technique;
    const TePicture shown = show(scene, "seamless-" + technique.name());
    EXPECT_GT(320 * 240 - countMagenta(shown), 10000) << technique.name();
    EXPECT_EQ(enclosedBackground(shown), 0) << technique.name();
    drawn.insert({technique.heights, technique.colours});
    EXPECT_EQ(scene.drawing->renderer(context().id())->programsCompiled(), int(drawn.size()))
        << technique.name();
    EXPECT_EQ(scene.counts.drawCalls == scene.counts.instances, !technique.instanced) << technique.name();
    pictures.push_back(shown);
  }
  for (std::size_t i = 0; i < pictures.size(); i += 2) {
    EXPECT_EQ(pictures[i], pictures[i + 1]) << TeSeamlessTechnique::all()[i].name(); // classic, instanced
    for (std::size_t j = 0; j < i; j += 2)
      EXPECT_NE(pictures[i], pictures[j]);
  }
  ASSERT_TRUE(context().makeCurrent());
  pyramid.free();
}

// Unlit, seen from above: what is drawn is the colour asked for.
TEST_F(TeSeamlessRendererTest, ColoursAreThoseOfTheTechniqueTimesTheMaterials) {
  SeamlessScene scene(seamlessLayout(64, 4, 3), 1);
  const auto model = unlit();
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(1, 1, 0.5f);
  const auto count = [&](const TePicture& shown, TePicture::Pixel pixel) {
    int number = 0;
    for (std::size_t i = 0; i < shown.rgba.size(); i += 4)
      number += std::equal(pixel.begin(), pixel.end(), &shown.rgba[i]);
    return number;
  };
  const TeNodePtr<SoMaterial> held(material);
  const auto shown = [&] { return show(scene, "", {model.get(), material}); };
  const TePicture plain = shown();
  const int tiles = count(plain, {255, 255, 128, 255});
  const int strips = count(plain, {255, 0, 0, 255});
  EXPECT_GT(tiles, 1000);
  EXPECT_GT(strips, 1000);
  EXPECT_EQ(tiles + strips, 320 * 240 - countMagenta(plain));

  scene.look.technique.colours = TeSeamlessTechnique::Texture;
  scene.look.texture = plainPicture(100, 200, 40);
  EXPECT_EQ(count(shown(), {100, 200, 20, 255}), tiles + strips);
  scene.look.technique.colours = TeSeamlessTechnique::Detailmaps;
  scene.look.mask = picture(2, [](int, int) { return TePicture::Pixel{0, 255, 0, 0}; });
  scene.look.details = {scene.look.texture, plainPicture(10, 20, 30), scene.look.texture, scene.look.texture};
  EXPECT_EQ(count(shown(), {10, 20, 15, 255}), tiles + strips);
  scene.look.technique.colours = TeSeamlessTechnique::Slope;
  for (auto& layer : scene.look.slopes.layers)
    layer.colour = {0.4f, 0.8f, 1};
  EXPECT_EQ(count(shown(), {102, 204, 128, 255}), tiles + strips);
}

TEST_F(TeSeamlessRendererTest, ATextureLiesOverTheTerrainFromTheSouthWest) {
  SeamlessScene scene(seamlessLayout(64, 4, 3), 1);
  scene.look.technique.colours = TeSeamlessTechnique::Texture;
  scene.look.texture = picture(64, [](int x, int y) {
    return TePicture::Pixel{std::uint8_t(x < 32 ? 250 : 10), std::uint8_t(y < 32 ? 250 : 10), 0, 255};
  });
  const auto model = unlit();
  const TeNodePtr<SoMaterial> white(new SoMaterial);
  white->diffuseColor.setValue(1, 1, 1);
  const TePicture shown = showFromAbove(scene, {model.get(), white.get()});
  EXPECT_EQ(shown.pixel(60, 60), (TePicture::Pixel{250, 250, 0, 255}));
  EXPECT_EQ(shown.pixel(180, 60), (TePicture::Pixel{10, 250, 0, 255}));
  EXPECT_EQ(shown.pixel(60, 180), (TePicture::Pixel{250, 10, 0, 255}));
  EXPECT_EQ(shown.pixel(180, 180), (TePicture::Pixel{10, 10, 0, 255}));
}

TEST_F(TeSeamlessRendererTest, WireframeShowsEdgesOnly) {
  const auto scene = hills();
  const int solid = 320 * 240 - countMagenta(show(*scene));
  scene->look.wireframe = true;
  scene->select(selectLevel(scene->layout, 1, [](const TeSideKey&) { return 0.0f; }));
  const int lines = 320 * 240 - countMagenta(show(*scene, "seamless-wireframe"));
  EXPECT_GT(lines, 1000);
  EXPECT_LT(lines, 0.7 * solid);
}

TEST_F(TeSeamlessRendererTest, HeightsAndPicturesAreUploadedOnceAndAgainWhenTheyChange) {
  const auto scene = hills(TeSeamlessTechnique::Texture);
  scene->look.texture = plainPicture(1, 2, 3);
  show(*scene);
  const std::int64_t heights = std::int64_t(129) * 129 * 8;
  EXPECT_GT(scene->counts.bytesUploaded, heights);
  const std::int64_t instances = scene->counts.instances * std::int64_t(sizeof(TeSeamlessInstance));
  show(*scene);
  EXPECT_EQ(scene->counts.bytesUploaded, instances);
  scene->look.technique.instanced = false;
  show(*scene);
  EXPECT_EQ(scene->counts.bytesUploaded, 0);
  scene->look.heights = hillyMap(128, 3);
  show(*scene);
  EXPECT_EQ(scene->counts.bytesUploaded, heights);
  scene->look.texture = plainPicture(3, 2, 1);
  show(*scene);
  EXPECT_EQ(scene->counts.bytesUploaded, 4 * 4 * 4);
}

TEST_F(TeSeamlessRendererTest, WhatATechniqueLacksIsAnErrorThatNamesIt) {
  SeamlessScene scene(seamlessLayout(128, 4, 3), 1);
  const auto errorOf = [&](const char* technique) {
    scene.look.technique = *TeSeamlessTechnique::named(technique);
    const TePicture shown = showNode(scene.node.get());
    EXPECT_EQ(countMagenta(shown), 320 * 240) << technique;
    return scene.error;
  };
  EXPECT_EQ(errorOf("HeightmapColorInstanced"),
            "seamless patches: technique HeightmapColorInstanced needs a height map");
  scene.look.heights = hillyMap(64);
  EXPECT_EQ(errorOf("HeightmapColorInstanced"), "seamless patches: technique HeightmapColorInstanced needs a "
                                                "height map of 129x129 samples, not 65x65");
  EXPECT_EQ(errorOf("ClipmapsColorClassic"),
            "seamless patches: technique ClipmapsColorClassic needs a clipmap of heights");
  EXPECT_EQ(errorOf("FlatTextureClassic"), "seamless patches: technique FlatTextureClassic needs a texture");
  EXPECT_EQ(errorOf("FlatDetailmapsClassic"),
            "seamless patches: technique FlatDetailmapsClassic needs a mask");
  scene.look.mask = plainPicture(255, 0, 0);
  scene.look.details[0] = scene.look.mask;
  EXPECT_EQ(errorOf("FlatDetailmapsClassic"), "seamless patches: technique FlatDetailmapsClassic needs four "
                                              "detail textures; number 2 is missing");
  TeHeightMap holes = *hillyMap(128);
  holes.at(3, 4) = TeHeightMap::missing();
  scene.look.heights = std::make_shared<const TeHeightMap>(std::move(holes));
  EXPECT_EQ(errorOf("HeightmapColorInstanced"),
            "seamless patches: a height map with missing samples cannot be drawn");
}

TEST_F(TeSeamlessRendererTest, AHeightMapTooLargeForTheGpuIsAnErrorThatRecommendsClipmaps) {
  GLint largest = 0;
  context().gl().getIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (largest > 16384)
    GTEST_SKIP() << "textures of " << largest;
  SeamlessScene scene(seamlessLayout(2 * largest, 16, 3), 1);
  scene.look.technique.heights = TeSeamlessTechnique::Heightmap;
  auto row = TeHeightMap::create(largest + 1, 1);
  ASSERT_TRUE(row);
  const auto map = std::make_shared<const TeHeightMap>(std::move(*row));
  TeSeamlessGl gl;
  ASSERT_TRUE(gl.load(context().id()));
  TeSeamlessObjects objects(gl);
  TeSeamlessTextures textures(gl, objects);
  const TeResult<GLuint> texture = textures.heights(map);
  ASSERT_FALSE(texture);
  const std::string side = std::to_string(largest);
  EXPECT_EQ(texture.error().message, "seamless patches: a height map of " + std::to_string(largest + 1) +
                                         "x1 does not fit into a texture, which this OpenGL allows to be " +
                                         side + "x" + side + "; draw it by clipmaps");
}

TEST_F(TeSeamlessRendererTest, AViewThatShowsNothingDrawsNothing) {
  const auto scene = hills();
  TeSeamlessRenderer renderer(context().id(), scene->layout, scene->parts);
  const TeSeamlessFrame flattened(scene->placement, glm::dmat4(0), glm::dmat4(1));
  const auto counts = renderer.draw(scene->lists, scene->look, flattened);
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->drawCalls, 0);
  EXPECT_EQ(renderer.programsCompiled(), 0);
}

TEST_F(TeSeamlessRendererTest, NothingOfItStaysBehind) {
  const std::int64_t before = TeSeamlessObjects::live();
  for (int round = 0; round < 3; round++) {
    const auto scene = hills(TeSeamlessTechnique::Texture);
    scene->look.texture = plainPicture(9, 9, 9);
    show(*scene);
    EXPECT_GT(TeSeamlessObjects::live(), before);
  }
  // Its objects go when the context is next drawn in.
  showNode(new SoSeparator);
  EXPECT_EQ(TeSeamlessObjects::live(), before);
}

TEST_F(TeSeamlessRendererTest, DrawsInTwoContextsAndOutlivesThem) {
  const std::int64_t before = TeSeamlessObjects::live();
  auto scene = hills();
  const TePicture first = show(*scene);
  const std::int64_t ofOne = TeSeamlessObjects::live() - before;
  {
    auto other = TeContext::create(s_kind, 64, 64);
    ASSERT_TRUE(other);
    EXPECT_EQ(renderIn(**other, scene->node.get()), first);
    EXPECT_EQ(TeSeamlessObjects::live(), before + 2 * ofOne);
  }
  EXPECT_EQ(TeSeamlessObjects::live(), before + ofOne);
  EXPECT_EQ(show(*scene), first);
  // The drawing goes before its context.
  {
    auto other = TeContext::create(s_kind, 64, 64);
    ASSERT_TRUE(other);
    renderIn(**other, scene->node.get());
    scene.reset();
  }
  showNode(new SoSeparator);
  EXPECT_EQ(TeSeamlessObjects::live(), before);
}

// The camera looks straight ahead, so that a column of pixels is a vertical plane: from above the ground, all
// below the highest pixel of ground in it is ground, or there is a crack.
TEST_F(TeSeamlessRendererTest, NoCrackShowsFromAnywhereAboveTheGround) {
  constexpr int kWidth = 200, kHeight = 150;
  const auto map = hillyMap(256, 3000, 8000);
  SeamlessPyramid pyramid(*map, 33, TeClipFormat::Half);
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * double(random()) / 4294967295.0;
  };
  auto renderer = TeSceneRenderer::create(context(), kWidth, kHeight);
  ASSERT_TRUE(renderer);
  (*renderer)->setBackground(SbColor(1, 0, 1));
  (*renderer)->setFitClipPlanes(false);
  SeamlessScene scene(seamlessLayout(256, 4, 3), 1);
  scene.placement.heightScale = 2e-3;
  scene.look.heights = map;
  const auto model = unlit();
  auto* camera = new SoPerspectiveCamera;
  camera->nearDistance = 0.01f;
  camera->farDistance = 1000;
  TeNodePtr<SoSeparator> root(new SoSeparator);
  root->addChild(camera);
  root->addChild(model.get());
  root->addChild(scene.node.get());
  std::int64_t ground = 0;
  for (int view = 0; view < 60; view++) {
    const double x = between(2, 254), y = between(2, 254);
    const double above = std::pow(10, between(0, 1.5));
    const double z = map->at(int(x), int(y)) * 2e-3 + above;
    camera->position.setValue(float(scene.placement.corner.x + x), float(scene.placement.corner.y + y),
                              float(z));
    const double heading = between(0, 6.28);
    camera->pointAt(camera->position.getValue() +
                        SbVec3f(float(std::cos(heading)), float(std::sin(heading)), 0),
                    SbVec3f(0, 0, 1));
    camera->heightAngle = float(between(0.6, 2.2));
    scene.look.geomorph = view % 2;
    const bool clipmaps = view % 3 != 0;
    scene.look.technique.heights = clipmaps ? TeSeamlessTechnique::Clipmaps : TeSeamlessTechnique::Heightmap;
    if (clipmaps)
      pyramid.update(context().id(), {between(0, 256), between(0, 256)}); // not always where the eye is
    scene.heightClipmap = &pyramid.clipmap;
    TeLodView lod;
    lod.eye = scene.placement.corner + glm::dvec3(x, y, z);
    TeSeamlessAccuracy accuracy;
    accuracy.precision = between(1, 4);
    accuracy.geomorph = scene.look.geomorph;
    TeSeamlessSelection selection;
    TeSeamlessSelector(scene.layout, nullptr)
        .select(lod, scene.placement, accuracy, clipmaps ? &pyramid.clipmap.residency : nullptr, selection);
    scene.select(selection);
    const TeResult<TePicture> picture = (*renderer)->render(root.get());
    ASSERT_TRUE(picture) << picture.error().message;
    ASSERT_EQ(scene.error, "");
    int cracks = 0;
    for (int column = 0; column < kWidth; column++) {
      int highest = kHeight - 1;
      while (highest >= 0 && picture->pixel(column, highest) == kMagenta)
        highest--;
      ground += highest + 1;
      for (int row = 0; row < highest; row++)
        cracks += picture->pixel(column, row) == kMagenta;
    }
    EXPECT_EQ(cracks, 0) << view;
  }
  std::printf("60 views, %lld pixels of ground, no crack\n", static_cast<long long>(ground));
  EXPECT_GT(ground, 60 * kWidth * kHeight / 4);
  ASSERT_TRUE(context().makeCurrent());
  pyramid.free();
}
