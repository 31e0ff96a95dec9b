#include "nodes/terrain/SoTeTerrainMesh.h"

#include "nodes/terrain/TeBlockGraph.h"
#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"

#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTextureCoordinatePlane.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoVertexShader.h>

#include <cmath>
#include <cstdio>

namespace {

class SoTeTerrainMeshTest : public TeRenderTest {
protected:
  /// Draws a block by our nodes and by Coin's, with the same nodes before both, and compares the pictures.
  TePixelDifference compareWithCoin(const TeStaticBlock& block, const std::vector<SoNode*>& before,
                                    const std::string& name) {
    TeNodePtr<SoSeparator> ours(new SoSeparator);
    TeNodePtr<SoSeparator> coins(new SoSeparator);
    for (SoNode* node : before) {
      ours->addChild(node);
      coins->addChild(node);
    }
    ours->addChild(meshGraph(block, drawingOf(block)).get());
    const auto graph = teBlockGraph(block);
    EXPECT_TRUE(graph);
    coins->addChild(graph->get());
    const TePicture mesh = draw(sideView(ours.get()).get(), 320, 240, "mesh-" + name);
    const TePicture coin = draw(sideView(coins.get()).get(), 320, 240, "mesh-" + name + "-coin");
    EXPECT_GT(320 * 240 - countMagenta(mesh), 5000);
    const TePixelDifference difference = comparePixels(mesh, coin);
    std::printf("%s: %d pixels differ, by %d at most\n", name.c_str(), difference.pixels, difference.largest);
    return difference;
  }

  TeStaticBlock faults() { return meshBlock(worldOf("faults", {}, 33, 3)); }
};

TeStaticBlock holes() {
  const auto source = std::make_shared<TeSampleFunction>([](std::int64_t x, std::int64_t y) {
    const bool isMissing = (x - 5) * (x - 5) + (y - 3) * (y - 3) < 40 || (x == 0 && y == 0);
    return isMissing ? std::nanf("") : float(std::sin(double(x) / 5) * 3 + double(y) / 9);
  });
  return meshBlock(worldOf(source, 33));
}

} // namespace

// The difference that remains is that of 16-bit normals from floats: one step of a channel.
TEST_F(SoTeTerrainMeshTest, DrawsThePictureOfCoinsOwnNodes) {
  EXPECT_LE(compareWithCoin(faults(), {}, "plain").largest, 1);
}

TEST_F(SoTeTerrainMeshTest, LeavesOutCellsWithAMissingCorner) {
  EXPECT_LE(compareWithCoin(holes(), {}, "holes").largest, 1);
}

TEST_F(SoTeTerrainMeshTest, DrawsMoreVerticesThan16BitsNumber) {
  const auto waves = std::make_shared<TeSampleFunction>(
      [](std::int64_t x, std::int64_t y) { return float((x & 63) * (y & 31)) * 0.01f; });
  const TeStaticBlock block = meshBlock(worldOf(waves, 545), {0, 0}, 1);
  auto drawing = drawingOf(block);
  const auto mesh = meshGraph(block, drawing);
  const auto coin = teBlockGraph(block);
  ASSERT_TRUE(coin);
  const TePicture ours = draw(sideView(mesh.get(), 300).get(), 320, 240, "mesh-large");
  EXPECT_GT(drawing->frame().triangles, 2 * 65536);
  EXPECT_LE(comparePixels(ours, draw(sideView(coin->get(), 300).get(), 320, 240)).largest, 1);
}

TEST_F(SoTeTerrainMeshTest, StandsUnderTransforms) {
  auto* transform = new SoTransform;
  transform->rotation.setValue(SbVec3f(0.2f, 0.1f, 1), 0.8f);
  transform->scaleFactor.setValue(1.2f, 0.8f, 0.5f);
  transform->translation.setValue(3, -4, 5);
  EXPECT_LE(compareWithCoin(faults(), {transform}, "transform").largest, 1);
}

TEST_F(SoTeTerrainMeshTest, FogHidesWhatIsFar) {
  auto* environment = new SoEnvironment;
  environment->fogType = SoEnvironment::FOG;
  environment->fogColor.setValue(0.6f, 0.7f, 0.8f);
  environment->fogVisibility = 180;
  const TeStaticBlock block = faults();
  EXPECT_LE(compareWithCoin(block, {environment}, "fog").largest, 1);
}

TEST_F(SoTeTerrainMeshTest, FollowsTheDrawStyle) {
  auto* lines = new SoDrawStyle;
  lines->style = SoDrawStyle::LINES;
  const TePixelDifference difference = compareWithCoin(faults(), {lines}, "lines");
  EXPECT_LE(difference.largest, 1);
  auto* invisible = new SoDrawStyle;
  invisible->style = SoDrawStyle::INVISIBLE;
  TeNodePtr<SoSeparator> hidden(new SoSeparator);
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  hidden->addChild(invisible);
  hidden->addChild(meshGraph(block, drawing).get());
  EXPECT_EQ(countMagenta(draw(sideView(hidden.get()).get(), 32, 32)), 32 * 32);
  EXPECT_EQ(drawing->frame().meshesDrawn, 0);
}

TEST_F(SoTeTerrainMeshTest, IsDrawnWithoutLightToo) {
  auto* model = new SoLightModel;
  model->model = SoLightModel::BASE_COLOR;
  EXPECT_EQ(compareWithCoin(faults(), {model}, "unlit").pixels, 0);
}

TEST_F(SoTeTerrainMeshTest, TakesTheMaterialsGloss) {
  auto* material = new SoMaterial;
  material->ambientColor.setValue(0.5f, 0.1f, 0.1f);
  material->specularColor.setValue(0.9f, 0.9f, 0.9f);
  material->emissiveColor.setValue(0, 0, 0.3f);
  material->shininess = 0.4f;
  // Highlights are steeper functions of the normal: 0.4 · 128 times.
  EXPECT_LE(compareWithCoin(faults(), {material}, "gloss").largest, 3);
}

TEST_F(SoTeTerrainMeshTest, OverriddenColoursTakeTheMeshsPlace) {
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(1, 1, 0);
  material->setOverride(TRUE);
  auto* model = new SoLightModel;
  model->model = SoLightModel::BASE_COLOR;
  TeNodePtr<SoSeparator> root(new SoSeparator);
  const TeStaticBlock block = faults();
  root->addChild(material);
  root->addChild(model);
  root->addChild(meshGraph(block, drawingOf(block)).get());
  const TePicture picture = draw(sideView(root.get()).get(), 64, 48, "mesh-override");
  EXPECT_EQ(picture.pixel(32, 20), (TePicture::Pixel{255, 255, 0, 255}));
}

TEST_F(SoTeTerrainMeshTest, TakesTexturesWithGeneratedCoordinates) {
  const unsigned char texels[] = {255, 255, 255, 40, 40, 40, 40, 40, 40, 255, 255, 255};
  const TeNodePtr<SoTexture2> texture(new SoTexture2);
  texture->image.setValue(SbVec2s(2, 2), 3, texels);
  const TeNodePtr<SoTextureCoordinatePlane> plane(new SoTextureCoordinatePlane);
  plane->directionS.setValue(0.1f, 0, 0);
  plane->directionT.setValue(0, 0.1f, 0);
  const TeStaticBlock block = faults();
  EXPECT_LE(compareWithCoin(block, {texture.get(), plane.get()}, "texture").largest, 1);
  const TePicture plain = draw(sideView(meshGraph(block, drawingOf(block)).get()).get(), 320, 240);
  const TePicture chequered = [&] {
    TeNodePtr<SoSeparator> root(new SoSeparator);
    root->addChild(texture.get());
    root->addChild(plane.get());
    root->addChild(meshGraph(block, drawingOf(block)).get());
    return draw(sideView(root.get()).get(), 320, 240);
  }();
  EXPECT_GT(comparePixels(plain, chequered).pixels, 3000);
}

// The scene's shaders get position, normal and colour as from Coin's nodes.
TEST_F(SoTeTerrainMeshTest, IsDrawnByTheScenesShaders) {
  auto* vertex = new SoVertexShader;
  vertex->sourceType = SoShaderObject::GLSL_PROGRAM;
  vertex->sourceProgram = "varying vec4 shade;\n"
                          "void main() {\n"
                          "  gl_Position = ftransform();\n"
                          "  shade = vec4(gl_Normal.xy * 0.5 + 0.5, gl_Color.g, 1.0);\n"
                          "}\n";
  auto* fragment = new SoFragmentShader;
  fragment->sourceType = SoShaderObject::GLSL_PROGRAM;
  fragment->sourceProgram = "varying vec4 shade;\n"
                            "void main() { gl_FragColor = shade; }\n";
  auto* program = new SoShaderProgram;
  program->shaderObject.set1Value(0, vertex);
  program->shaderObject.set1Value(1, fragment);
  EXPECT_LE(compareWithCoin(faults(), {program}, "shader").largest, 1);
}

TEST_F(SoTeTerrainMeshTest, AnotherMeshIsAnotherPicture) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  const auto mesh =
      std::make_shared<const TePatchMesh>(*block.database().patchMesh(*block.database().find({0, 0, 0})));
  TeNodePtr<SoTeTerrainMesh> node(new SoTeTerrainMesh);
  TeNodePtr<SoSeparator> graph(new SoSeparator);
  graph->addChild(drawing->translation());
  graph->addChild(node.get());
  const auto scene = sideView(graph.get(), 40);
  EXPECT_EQ(countMagenta(draw(scene.get(), 64, 48)), 64 * 48); // no mesh yet
  const auto count = mesh->positions.size();
  node->setMesh(mesh, std::vector<std::uint32_t>(count, 0xFF0000FF), drawing);
  const TePicture red = draw(scene.get(), 64, 48, "mesh-red");
  EXPECT_GT(red.pixel(32, 24)[0], red.pixel(32, 24)[1]);
  node->setMesh(mesh, std::vector<std::uint32_t>(count, 0x00FF00FF), drawing);
  const TePicture green = draw(scene.get(), 64, 48, "mesh-green");
  EXPECT_GT(green.pixel(32, 24)[1], green.pixel(32, 24)[0]);
  const TeNodePtr<SoSeparator> copy(static_cast<SoSeparator*>(scene->copy()));
  EXPECT_EQ(draw(copy.get(), 64, 48), green);
  node->setMesh(nullptr, {}, drawing);
  EXPECT_EQ(countMagenta(draw(scene.get(), 64, 48)), 64 * 48);
  EXPECT_EQ(draw(copy.get(), 64, 48), green);
}
