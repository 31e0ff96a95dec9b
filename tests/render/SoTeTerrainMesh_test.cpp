#include "nodes/terrain/SoTeTerrainMesh.h"

#include "nodes/terrain/TeBlockGraph.h"
#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTextureCoordinatePlane.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/nodes/SoVertexShader.h>

#include <GL/glext.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <type_traits>

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

/// OpenGL state that a neighbour may rely on.
struct GlState {
  GLint vertexArray = 0;
  GLint arrayBuffer = 0;
  GLint elementBuffer = 0;
  GLint program = 0;
  GLint activeTexture = 0;
  GLint clientTexture = 0;
  GLint vertexArrayOn = 0, normalArrayOn = 0, colourArrayOn = 0;
  GLint colourBuffer = 0; ///< that the colour array reads from
  GLint clientDepth = 0;
  GLint isBlended = 0, isDepthTested = 0, isCulled = 0;
  GLint texture = 0;

  bool operator==(const GlState& other) const { return std::memcmp(this, &other, sizeof *this) == 0; }
};

/// Puts OpenGL into a state that is not the usual one, and looks at what is left of it: to be put around a
/// mesh.
class Neighbour {
public:
  explicit Neighbour(const TeContext& context) : m_gl(context.gl()) {
    const auto find = [&](auto*& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(context.procAddress(name));
      ASSERT_TRUE(function) << name;
    };
    find(m_genVertexArrays, "glGenVertexArrays");
    find(m_bindVertexArray, "glBindVertexArray");
    find(m_genBuffers, "glGenBuffers");
    find(m_bindBuffer, "glBindBuffer");
    find(m_bufferData, "glBufferData");
    find(m_enableClientState, "glEnableClientState");
    find(m_colorPointer, "glColorPointer");
    find(m_enableVertexAttribArray, "glEnableVertexAttribArray");
    find(m_vertexAttribPointer, "glVertexAttribPointer");
  }

  TeNodePtr<SoCallback> before() {
    return callback([](void* self, SoAction* action) {
      if (action->isOfType(SoGLRenderAction::getClassTypeId()))
        static_cast<Neighbour*>(self)->bind();
    });
  }
  TeNodePtr<SoCallback> after() {
    return callback([](void* self, SoAction* action) {
      if (action->isOfType(SoGLRenderAction::getClassTypeId()))
        static_cast<Neighbour*>(self)->unbind();
    });
  }

  int looks = 0;
  int changes = 0;

private:
  static TeNodePtr<SoCallback> callback(SoCallbackCB* function, void* self) {
    TeNodePtr<SoCallback> node(new SoCallback);
    node->setCallback(function, self);
    return node;
  }
  TeNodePtr<SoCallback> callback(SoCallbackCB* function) { return callback(function, this); }

  void bind() {
    if (!m_vertexArray) {
      m_genVertexArrays(1, &m_vertexArray);
      m_genBuffers(2, m_buffers);
      const float colours[8] = {};
      for (const GLuint buffer : m_buffers) {
        m_bindBuffer(GL_ARRAY_BUFFER, buffer);
        m_bufferData(GL_ARRAY_BUFFER, sizeof colours, colours, GL_STATIC_DRAW);
      }
    }
    m_bindVertexArray(m_vertexArray);
    m_bindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    m_bindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
    m_colorPointer(4, GL_FLOAT, 0, nullptr);
    m_enableClientState(GL_COLOR_ARRAY);
    m_vertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr); // comes before the vertex array
    m_enableVertexAttribArray(0);
    m_before = look();
  }

  void unbind() {
    looks++;
    changes += !(look() == m_before);
    m_bindVertexArray(0);
    m_bindBuffer(GL_ARRAY_BUFFER, 0);
  }

  GlState look() const {
    GlState state;
    m_gl.getIntegerv(GL_VERTEX_ARRAY_BINDING, &state.vertexArray);
    m_gl.getIntegerv(GL_ARRAY_BUFFER_BINDING, &state.arrayBuffer);
    m_gl.getIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &state.elementBuffer);
    m_gl.getIntegerv(GL_CURRENT_PROGRAM, &state.program);
    m_gl.getIntegerv(GL_ACTIVE_TEXTURE, &state.activeTexture);
    m_gl.getIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &state.clientTexture);
    m_gl.getIntegerv(GL_VERTEX_ARRAY, &state.vertexArrayOn);
    m_gl.getIntegerv(GL_NORMAL_ARRAY, &state.normalArrayOn);
    m_gl.getIntegerv(GL_COLOR_ARRAY, &state.colourArrayOn);
    m_gl.getIntegerv(GL_COLOR_ARRAY_BUFFER_BINDING, &state.colourBuffer);
    m_gl.getIntegerv(GL_CLIENT_ATTRIB_STACK_DEPTH, &state.clientDepth);
    m_gl.getIntegerv(GL_BLEND, &state.isBlended);
    m_gl.getIntegerv(GL_DEPTH_TEST, &state.isDepthTested);
    m_gl.getIntegerv(GL_CULL_FACE, &state.isCulled);
    m_gl.getIntegerv(GL_TEXTURE_BINDING_2D, &state.texture);
    return state;
  }

  const TeGlTable& m_gl;
  void (*m_genVertexArrays)(GLsizei, GLuint*) = nullptr;
  void (*m_bindVertexArray)(GLuint) = nullptr;
  void (*m_genBuffers)(GLsizei, GLuint*) = nullptr;
  void (*m_bindBuffer)(GLenum, GLuint) = nullptr;
  void (*m_bufferData)(GLenum, GLsizeiptr, const void*, GLenum) = nullptr;
  void (*m_enableClientState)(GLenum) = nullptr;
  void (*m_colorPointer)(GLint, GLenum, GLsizei, const void*) = nullptr;
  void (*m_enableVertexAttribArray)(GLuint) = nullptr;
  void (*m_vertexAttribPointer)(GLuint, GLint, GLenum, GLboolean, GLsizei, const void*) = nullptr;
  GLuint m_vertexArray = 0;
  GLuint m_buffers[2] = {};
  GlState m_before;
};

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

TEST_F(SoTeTerrainMeshTest, LeavesOpenGlAsItFoundIt) {
  const TeStaticBlock block = faults();
  TeNodePtr<SoSeparator> terrain = meshGraph(block, drawingOf(block));
  Neighbour neighbour(context());
  TeNodePtr<SoSeparator> graph(new SoSeparator);
  graph->addChild(terrain->getChild(0));
  graph->addChild(terrain->getChild(1));
  for (int i = 2; i < terrain->getNumChildren(); i++) {
    graph->addChild(neighbour.before().get());
    graph->addChild(terrain->getChild(i));
    graph->addChild(neighbour.after().get());
  }
  const auto scene = sideView(graph.get());
  const TePicture first = draw(scene.get(), 160, 120, "mesh-state"); // with uploads
  EXPECT_EQ(draw(scene.get(), 160, 120), first);
  EXPECT_EQ(neighbour.looks, 2 * 25);
  EXPECT_EQ(neighbour.changes, 0);
  EXPECT_EQ(first, draw(sideView(terrain.get()).get(), 160, 120));
}

// A shape of Coin's own, drawn from its buffers and with its material, is the same before and after terrain.
TEST_F(SoTeTerrainMeshTest, NeighboursLookAsWithoutIt) {
  const TeStaticBlock block = faults();
  const auto shapes = [](float x) {
    auto* root = new SoSeparator;
    auto* translation = new SoTranslation;
    translation->translation.setValue(x, 0, 0);
    root->addChild(translation);
    auto* sphere = new SoSphere; // with the default material that came before
    sphere->radius = 6;
    root->addChild(sphere);
    auto* material = new SoMaterial;
    material->diffuseColor.setValue(0.9f, 0.3f, 0.1f);
    root->addChild(material);
    auto* away = new SoTranslation;
    away->translation.setValue(0, 14, 0);
    root->addChild(away);
    root->addChild(new SoCone);
    return root;
  };
  const auto hidden = drawingOf(block);
  TeNodePtr<SoSeparator> alone(new SoSeparator);
  TeNodePtr<SoSeparator> among(new SoSeparator);
  for (SoSeparator* root : {alone.get(), among.get()}) {
    root->addChild(shapes(-12));
    if (root == among.get()) {
      auto* aside = new SoSeparator;
      auto* translation = new SoTranslation;
      translation->translation.setValue(0, 0, -500); // out of view: only its traces could be seen
      aside->addChild(translation);
      aside->addChild(meshGraph(block, drawingOf(block)).get());
      auto* near = new SoSeparator;
      auto* scale = new SoTransform;
      scale->scaleFactor.setValue(1e-4f, 1e-4f, 1e-4f); // drawn, and hidden in the sphere
      scale->translation.setValue(-12, 0, 0);
      near->addChild(scale);
      near->addChild(meshGraph(block, hidden).get());
      root->addChild(aside);
      root->addChild(near);
    }
    root->addChild(shapes(12));
  }
  for (int frame = 0; frame < 3; frame++)
    EXPECT_EQ(draw(sideView(alone.get(), 60).get(), 160, 120),
              draw(sideView(among.get(), 60).get(), 160, 120));
  EXPECT_EQ(hidden->frame().meshesDrawn, 3 * 25);
}

TEST_F(SoTeTerrainMeshTest, RenderCachingChangesNoPixel) {
  const TeStaticBlock block = faults();
  std::vector<TePicture> pictures;
  for (const SoSeparator::CacheEnabled caching : {SoSeparator::OFF, SoSeparator::ON, SoSeparator::AUTO}) {
    const auto graph = meshGraph(block, drawingOf(block));
    graph->renderCaching = caching;
    const auto scene = sideView(graph.get());
    scene->renderCaching = caching;
    auto renderer = TeSceneRenderer::create(context(), 160, 120);
    ASSERT_TRUE(renderer) << renderer.error().message;
    for (int frame = 0; frame < 4; frame++) {
      TeResult<TePicture> picture = (*renderer)->render(scene.get());
      ASSERT_TRUE(picture) << picture.error().message;
      pictures.push_back(std::move(*picture));
    }
  }
  EXPECT_LT(countMagenta(pictures[0]), 160 * 120 - 2000);
  for (std::size_t i = 1; i < pictures.size(); i++)
    EXPECT_EQ(pictures[i], pictures[0]) << i;
}

TEST_F(SoTeTerrainMeshTest, IsDrawnInTwoContextsByTurns) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  auto graph = meshGraph(block, drawing);
  auto scene = sideView(graph.get());
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other) << other.error().message;
  auto first = TeSceneRenderer::create(context(), 160, 120);
  auto second = TeSceneRenderer::create(**other, 160, 120);
  ASSERT_TRUE(first && second);
  const TePicture picture = *(*first)->render(scene.get());
  const std::size_t once = drawing->bufferBytes();
  EXPECT_EQ(picture, *(*second)->render(scene.get()));
  EXPECT_EQ(drawing->bufferBytes(), 2 * once);
  EXPECT_EQ(picture, *(*first)->render(scene.get()));

  // The second context goes, and only its buffers with it.
  second->reset();
  other->reset();
  EXPECT_EQ(drawing->bufferBytes(), once);
  EXPECT_EQ(picture, *(*first)->render(scene.get()));
}

TEST_F(SoTeTerrainMeshTest, TwoRenderActionsOfOneContextShareItsBuffers) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  const auto scene = sideView(meshGraph(block, drawing).get());
  auto first = TeSceneRenderer::create(context(), 160, 120);
  auto second = TeSceneRenderer::create(context(), 160, 120);
  ASSERT_TRUE(first && second);
  const TePicture picture = *(*first)->render(scene.get());
  const std::size_t bytes = drawing->bufferBytes();
  EXPECT_EQ(picture, *(*second)->render(scene.get()));
  EXPECT_EQ(drawing->bufferBytes(), bytes);
}

TEST_F(SoTeTerrainMeshTest, DrawsOnlyWhatIsInViewAndUploadsTheRestToo) {
  const TeStaticBlock block = faults();
  const auto drawing = drawingOf(block);
  const auto scene = sideView(meshGraph(block, drawing).get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  camera->position.setValue(0, 0, 30);
  camera->pointAt(SbVec3f(30, 1, 0), SbVec3f(0, 0, 1)); // down to the east
  auto renderer = TeSceneRenderer::create(context(), 64, 48);
  ASSERT_TRUE(renderer);
  ASSERT_TRUE((*renderer)->draw(scene.get()));
  const TeMeshDrawing::Frame first = drawing->frame();
  EXPECT_EQ(first.meshesDrawn + first.meshesCulled, 25);
  EXPECT_GT(first.meshesDrawn, 4);
  EXPECT_GT(first.meshesCulled, 8);
  EXPECT_EQ(first.uploads, 25);
  EXPECT_EQ(first.bytesUploaded, std::int64_t(drawing->bufferBytes()));
  EXPECT_GT(first.uploadSeconds, 0);

  drawing->resetFrame();
  EXPECT_GT(drawing->secondsPerByte(), 0);
  camera->pointAt(SbVec3f(-30, 1, 0), SbVec3f(0, 0, 1));
  ASSERT_TRUE((*renderer)->draw(scene.get()));
  EXPECT_GT(drawing->frame().meshesDrawn, 4);
  EXPECT_EQ(drawing->frame().uploads, 0);
}

TEST_F(SoTeTerrainMeshTest, NothingOfItStaysBehind) {
  const TeStaticBlock block = faults();
  auto renderer = TeSceneRenderer::create(context(), 32, 24);
  ASSERT_TRUE(renderer);
  const auto drawing = drawingOf(block);
  auto graph = meshGraph(block, drawing);
  auto scene = sideView(graph.get());
  std::size_t most = 0;
  for (int round = 0; round < 20; round++) {
    ASSERT_TRUE((*renderer)->draw(scene.get()));
    most = std::max(most, drawing->bufferBytes());
    auto next = meshGraph(block, drawing);
    scene->replaceChild(graph.get(), next.get());
    graph = next;
  }
  std::size_t added = 0;
  for (int i = 2; i < graph->getNumChildren(); i++)
    added += static_cast<SoTeTerrainMesh*>(graph->getChild(i))->uploadBytes();
  EXPECT_GT(most, added);
  EXPECT_LT(most, 2 * added); // with shared indices
  scene->removeChild(graph.get());
  graph = TeNodePtr<SoSeparator>();
  EXPECT_GT(drawing->bufferBytes(), 0u);
  ASSERT_TRUE((*renderer)->draw(scene.get())); // the context is current again: its buffers go
  EXPECT_EQ(drawing->bufferBytes(), 0u);
}

TEST_F(SoTeTerrainMeshTest, OutlivesItsContextAndItsDrawingsOwner) {
  const TeStaticBlock block = faults();
  auto drawing = drawingOf(block);
  auto other = TeContext::create(s_kind, 64, 64);
  ASSERT_TRUE(other);
  auto graph = meshGraph(block, drawing);
  {
    auto renderer = TeSceneRenderer::create(**other, 32, 24);
    ASSERT_TRUE(renderer);
    ASSERT_TRUE((*renderer)->draw(sideView(graph.get()).get()));
    EXPECT_GT(drawing->bufferBytes(), 0u);
    graph->removeChild(graph->getNumChildren() - 1); // waits to be freed as the context goes
  }
  other->reset();
  EXPECT_EQ(drawing->bufferBytes(), 0u);
  drawing.reset();
  EXPECT_LT(countMagenta(draw(sideView(graph.get()).get(), 64, 48)), 64 * 48);
  graph = TeNodePtr<SoSeparator>(); // the nodes, and the drawing with them
  draw(sideView(new SoSeparator).get(), 8, 8);
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
