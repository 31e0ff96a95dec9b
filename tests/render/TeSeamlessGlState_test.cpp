#include "nodes/seamless/TeSeamlessGlState.h"

#include "render/SeamlessRenderTest.h"
#include "render/TeGlNeighbour.h"
#include "render/seamlessPyramid.h"

namespace {

using TeSeamlessGlStateTest = SeamlessRenderTest;

/// OpenGL state that Seamless Patches use, beyond that of TeGlNeighbour, set to what is not usual.
class Neighbour {
public:
  explicit Neighbour(const TeContext& context) {
    EXPECT_TRUE(m_gl.load(context.id()));
    find(context, "glGetVertexAttribIiv", m_getAttribute);
  }
  TeNodePtr<SoCallback> before() {
    return callback([](void* self, SoAction* action) {
      if (action->isOfType(SoGLRenderAction::getClassTypeId()))
        static_cast<Neighbour*>(self)->set();
    });
  }
  TeNodePtr<SoCallback> after() {
    return callback([](void* self, SoAction* action) {
      if (action->isOfType(SoGLRenderAction::getClassTypeId()))
        static_cast<Neighbour*>(self)->compare();
    });
  }
  int looks = 0;

private:
  using State = std::vector<GLint>;

  template <class Function>
  static void find(const TeContext& context, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(context.procAddress(name));
  }
  TeNodePtr<SoCallback> callback(SoCallbackCB* function) {
    TeNodePtr<SoCallback> node(new SoCallback);
    node->setCallback(function, this);
    return node;
  }
  void set() {
    for (GLuint unit = 0; unit < 8; unit++) {
      m_gl.genTextures(2, m_textures[unit]);
      m_gl.genSamplers(1, &m_samplers[unit]);
      m_gl.activeTexture(GL_TEXTURE0 + unit);
      m_gl.bindTexture(GL_TEXTURE_2D, m_textures[unit][0]);
      m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, m_textures[unit][1]);
      m_gl.bindSampler(unit, m_samplers[unit]);
    }
    m_gl.activeTexture(GL_TEXTURE5);
    for (GLuint attribute = 1; attribute < 8; attribute += 5) // 1 and 6: of no fixed function's
      m_gl.vertexAttribI4i(attribute, 7, -8, 9, 10);
    m_gl.vertexAttribI4i(7, 1, -2, 3, -4);
    m_gl.enable(GL_PRIMITIVE_RESTART); // at index 0
    m_gl.pixelStorei(GL_UNPACK_ROW_LENGTH, 3);
    m_gl.pixelStorei(GL_UNPACK_ALIGNMENT, 8);
    m_gl.genBuffers(1, &m_unpack);
    m_gl.bindBuffer(GL_PIXEL_UNPACK_BUFFER, m_unpack);
    m_gl.polygonMode(GL_FRONT_AND_BACK, GL_FILL);
    m_before = look();
  }
  void compare() {
    looks++;
    EXPECT_EQ(look(), m_before);
    for (GLuint unit = 0; unit < 8; unit++) {
      m_gl.bindSampler(unit, 0);
      m_gl.deleteTextures(2, m_textures[unit]);
      m_gl.deleteSamplers(1, &m_samplers[unit]);
    }
    m_gl.deleteBuffers(1, &m_unpack);
    m_gl.activeTexture(GL_TEXTURE0);
    m_gl.disable(GL_PRIMITIVE_RESTART);
    m_gl.pixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    m_gl.pixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  State look() const {
    State state;
    const auto add = [&](GLenum name, int count = 1) {
      state.resize(state.size() + std::size_t(count));
      m_gl.getIntegerv(name, &state[state.size() - std::size_t(count)]);
    };
    for (const GLenum name :
         {GL_ACTIVE_TEXTURE, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING,
          GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_UNPACK_ROW_LENGTH, GL_UNPACK_ALIGNMENT,
          GL_PIXEL_UNPACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_PRIMITIVE_RESTART,
          GL_RASTERIZER_DISCARD, GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_TEXTURE_2D})
      add(name);
    add(GL_POLYGON_MODE, 2);
    add(GL_CURRENT_COLOR, 4);
    const GLint active = state.front();
    for (GLuint unit = 0; unit < 8; unit++) {
      m_gl.activeTexture(GL_TEXTURE0 + unit);
      for (const GLenum name : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY, GL_SAMPLER_BINDING})
        add(name);
    }
    m_gl.activeTexture(GLenum(active));
    for (GLuint attribute = 1; attribute < 16; attribute++) {
      state.resize(state.size() + 4);
      m_getAttribute(attribute, GL_CURRENT_VERTEX_ATTRIB, &state[state.size() - 4]);
    }
    return state;
  }

  TeSeamlessGl m_gl;
  void (*m_getAttribute)(GLuint, GLenum, GLint*) = nullptr;
  GLuint m_textures[8][2] = {};
  GLuint m_samplers[8] = {};
  GLuint m_unpack = 0;
  State m_before;
};

} // namespace

TEST_F(TeSeamlessGlStateTest, LeavesOpenGlToItsNeighboursAsItWas) {
  const auto map = hillyMap(128, 12, 20);
  SeamlessPyramid pyramid(*map, 33, TeClipFormat::Short);
  SeamlessPyramid colours(*map, 33, TeClipFormat::Colour);
  pyramid.update(context().id(), {60, 70});
  colours.update(context().id(), {60, 70});
  SeamlessScene scene(seamlessLayout(128, 4, 3), 1);
  scene.selectAround(2, false, &pyramid.clipmap.residency);
  scene.heightClipmap = &pyramid.clipmap;
  scene.look.heights = map;
  scene.look.texture = scene.look.mask = plainPicture(1, 2, 3);
  scene.look.details = {scene.look.mask, scene.look.mask, scene.look.mask, scene.look.mask};
  Neighbour first(context());
  TeGlNeighbour second(context());
  TeNodePtr<SoSeparator> group(new SoSeparator);
  group->addChild(first.before().get());
  group->addChild(second.before().get());
  group->addChild(scene.node.get());
  group->addChild(second.after().get());
  group->addChild(first.after().get());
  int frames = 0;
  for (const TeSeamlessTechnique& technique : TeSeamlessTechnique::all())
    for (const bool unusual : {false, true}) {
      scene.look.technique = technique;
      scene.look.wireframe = unusual;
      scene.colourClipmap = unusual ? &colours.clipmap : nullptr;
      scene.captures = unusual && technique.colours == TeSeamlessTechnique::Slope;
      showNode(group.get());
      EXPECT_EQ(scene.error, "") << technique.name();
      frames++;
    }
  EXPECT_EQ(first.looks, frames);
  EXPECT_EQ(second.looks, frames);
  EXPECT_EQ(second.changes, 0);
  ASSERT_TRUE(context().makeCurrent());
  pyramid.free();
  colours.free();
}
