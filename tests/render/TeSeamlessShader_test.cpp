#include "nodes/seamless/TeSeamlessShader.h"

#include "nodes/seamless/SoTeSeamlessPatches.h"
#include "render/SeamlessRenderTest.h"
#include "render/seamlessPyramid.h"

#include <Inventor/nodes/SoClipPlane.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPointLight.h>
#include <Inventor/nodes/SoRotation.h>
#include <Inventor/nodes/SoScale.h>
#include <Inventor/nodes/SoSpotLight.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <cstdio>

namespace {

/// The same triangles by Coin, with the normals of the height map's samples.
TeNodePtr<SoSeparator> coinShape(const SeamlessScene& scene) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* vertices = new SoVertexProperty;
  auto* faces = new SoIndexedFaceSet;
  const TeHeightMap& map = *scene.look.heights;
  const int last = map.width() - 1;
  for (int y = 0; y <= last; y++)
    for (int x = 0; x <= last; x++) {
      const auto slope = [&](int dx, int dy) {
        const int x0 = std::max(x - dx, 0), x1 = std::min(x + dx, last);
        const int y0 = std::max(y - dy, 0), y1 = std::min(y + dy, last);
        return (map.at(x1, y1) - map.at(x0, y0)) / float(x1 - x0 + y1 - y0);
      };
      const glm::dvec3 place = scene.placement.corner + glm::dvec3(x, y, map.at(x, y));
      const int number = y * map.width() + x;
      vertices->vertex.set1Value(number, SbVec3f(float(place.x), float(place.y), float(place.z)));
      SbVec3f normal(-slope(1, 0), -slope(0, 1), 1);
      normal.normalize();
      vertices->normal.set1Value(number, normal);
    }
  std::vector<TeSeamlessMesh::Triangle> mesh;
  for (const TeSeamlessPatch& patch : scene.selection.patches)
    TeSeamlessMesh::appendPatch(patch, scene.layout, *scene.parts,
                                TeSeamlessMapHeights(scene.look.heights.get()), mesh);
  int count = 0;
  faces->coordIndex.setNum(int(4 * mesh.size()));
  std::int32_t* index = faces->coordIndex.startEditing();
  for (const TeSeamlessMesh::Triangle& triangle : mesh) {
    for (const TeSeamlessMesh::Vertex& vertex : {triangle.a, triangle.b, triangle.c})
      index[count++] = vertex.row * map.width() + vertex.column;
    index[count++] = -1;
  }
  faces->coordIndex.finishEditing();
  faces->vertexProperty = vertices;
  root->addChild(faces);
  return root;
}

class TeSeamlessShaderTest : public SeamlessRenderTest {
protected:
  /// Against Coin's own shape with the same nodes before it; pixels on edges may fall to either side.
  void expectAsCoin(const std::string& name, const std::vector<SoNode*>& before) {
    const auto scene = hills(TeSeamlessTechnique::Color);
    scene->look.stripColour = {1, 1, 1};
    scene->selectAround(3, false);
    const TePicture ours = show(*scene, "seamless-as-coin-" + name, before);
    const TePicture coins = showNode(coinShape(*scene).get(), "seamless-as-coin-" + name + "-coin", before);
    EXPECT_GT(320 * 240 - countMagenta(ours), 5000) << name;
    int different = 0;
    for (std::size_t i = 0; i < ours.rgba.size(); i += 4) {
      int largest = 0;
      for (std::size_t j = i; j < i + 4; j++)
        largest = std::max(largest, std::abs(int(ours.rgba[j]) - int(coins.rgba[j])));
      different += largest > 2;
    }
    std::printf("%s: %d pixels differ by more than 2\n", name.c_str(), different);
    EXPECT_LT(different, 100) << name;
  }
};

template <class Node> Node* light(const SbVec3f& colour) {
  auto* made = new Node;
  made->color.setValue(colour);
  return made;
}

} // namespace

TEST_F(TeSeamlessShaderTest, LightsAreThoseOfTheScene) {
  expectAsCoin("sun", {});
  const TeNodePtr<SoEnvironment> ambient(new SoEnvironment);
  ambient->ambientIntensity = 0.7f;
  const TeNodePtr<SoMaterial> gloss(new SoMaterial);
  gloss->diffuseColor.setValue(0.2f, 0.5f, 0.3f);
  gloss->ambientColor.setValue(0.3f, 0.1f, 0.1f);
  gloss->emissiveColor.setValue(0, 0, 0.2f);
  gloss->specularColor.setValue(0.8f, 0.8f, 0.6f);
  gloss->shininess = 0.3f;
  expectAsCoin("gloss", {ambient.get(), gloss.get()});
  const TeNodePtr<SoPointLight> lamp(light<SoPointLight>({1, 0.4f, 0.2f}));
  lamp->location.setValue(10, -20, 25);
  const TeNodePtr<SoSpotLight> spot(light<SoSpotLight>({0.2f, 0.9f, 0.2f}));
  spot->location.setValue(-20, 20, 60);
  spot->direction.setValue(0.1f, 0, -1);
  spot->cutOffAngle = 0.6f;
  spot->dropOffRate = 0.2f;
  ambient->attenuation.setValue(1e-4f, 0.004f, 0.5f);
  expectAsCoin("lamps", {ambient.get(), lamp.get(), spot.get()});
  const auto model = unlit();
  expectAsCoin("unlit", {model.get(), gloss.get()});
}

TEST_F(TeSeamlessShaderTest, IsTransparentOnlyIfTheMaterialIs) {
  const TeNodePtr<SoTeSeamlessPatches> terrain(new SoTeSeamlessPatches);
  terrain->size.setValue(128, 128, 1);
  terrain->resolution = 64;
  terrain->stripColor.setValue(1, 1, 1);
  const auto model = unlit();
  const TeNodePtr<SoMaterial> glass(new SoMaterial);
  glass->diffuseColor.setValue(0, 1, 0);
  EXPECT_EQ(showNode(terrain.get(), "", {model.get(), glass.get()}).pixel(160, 120),
            (TePicture::Pixel{0, 255, 0, 255}));
  glass->transparency = 0.6f;
  EXPECT_EQ(showNode(terrain.get(), "", {model.get(), glass.get()}).pixel(160, 120),
            (TePicture::Pixel{153, 102, 153, 255}));
}

TEST_F(TeSeamlessShaderTest, StandsInFogAndUnderTransformsAndIsCutByPlanes) {
  const TeNodePtr<SoEnvironment> fog(new SoEnvironment);
  fog->fogColor.setValue(0.6f, 0.7f, 0.8f);
  fog->fogVisibility = 260;
  for (const auto kind : {SoEnvironment::HAZE, SoEnvironment::FOG, SoEnvironment::SMOKE}) {
    fog->fogType = kind;
    expectAsCoin("fog-" + std::to_string(int(kind)), {fog.get()});
  }
  const TeNodePtr<SoClipPlane> plane(new SoClipPlane);
  plane->plane.setValue(SbPlane(SbVec3f(1, 0.3f, 0.2f), -5));
  expectAsCoin("cut", {plane.get()});
  const TeNodePtr<SoRotation> rotation(new SoRotation);
  rotation->rotation.setValue(SbVec3f(0.2f, 0.1f, 1), 0.8f);
  const TeNodePtr<SoScale> scale(new SoScale);
  scale->scaleFactor.setValue(1.2f, 0.7f, 1.5f);
  expectAsCoin("turned", {rotation.get(), scale.get()});
}

TEST_F(TeSeamlessShaderTest, BacksAreLitOnlyWhereTheSceneIsTwoSided) {
  const TeNodePtr<SoRotation> over(new SoRotation);
  over->rotation.setValue(SbVec3f(1, 0, 0), 2.6f);
  const TeNodePtr<SoShapeHints> hints(new SoShapeHints);
  expectAsCoin("back", {over.get(), hints.get()});
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  expectAsCoin("two-sided", {over.get(), hints.get()});
  hints->shapeType = SoShapeHints::SOLID;
  expectAsCoin("culled", {over.get(), hints.get()});
}

// Grey by a smooth function, so that a texel in a wrong place or of a wrong level shows; around the middle of
// a small clipmap it is as fine as the screen, elsewhere coarser.
TEST_F(TeSeamlessShaderTest, AColourClipmapLiesSampleOnSample) {
  TeHeightMap grey = std::move(*TeHeightMap::create(129, 129));
  for (int y = 0; y <= 128; y++)
    for (int x = 0; x <= 128; x++)
      grey.at(x, y) = std::round(float(128 + 60 * std::sin(x * 0.11) + 60 * std::cos(y * 0.07)));
  const auto model = unlit();
  const TeNodePtr<SoMaterial> white(new SoMaterial);
  white->diffuseColor.setValue(1, 1, 1);
  for (const int clipSize : {129, 33}) {
    SeamlessPyramid pyramid(grey, clipSize, TeClipFormat::Colour);
    pyramid.update(context().id(), {48, 80});
    SeamlessScene scene(seamlessLayout(64, 4, 3), 1); // of another resolution
    scene.look.technique.colours = TeSeamlessTechnique::Texture;
    scene.colourClipmap = &pyramid.clipmap;
    const TePicture shown = showFromAbove(scene, {model.get(), white.get()});
    EXPECT_EQ(scene.error, "");
    int fine = 0;
    for (int y = 1; y < 240; y++)
      for (int x = 1; x < 240; x++) {
        const double column = (x + 0.5) / 240 * 128, row = (y + 0.5) / 240 * 128;
        const double expected = 128 + 60 * std::sin(column * 0.11) + 60 * std::cos(row * 0.07);
        const double difference = std::abs(shown.pixel(x, y)[1] - expected);
        fine += difference <= 2;
        // Between samples 4 apart a straight line is off by 4² / 8 · 60 · (0.11² + 0.07²) = 2.
        ASSERT_LE(difference, clipSize == 129 ? 2 : 4) << clipSize << ": " << x << " " << y;
      }
    EXPECT_GT(fine, 239 * 239 / 4);
    ASSERT_TRUE(context().makeCurrent());
    pyramid.free();
  }
}
