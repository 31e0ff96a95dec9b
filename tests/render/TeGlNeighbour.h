#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/context/TeContext.h"

#include <GL/glext.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoCallback.h>

#include <gtest/gtest.h>

#include <cstring>
#include <type_traits>

/// OpenGL state that a neighbour may rely on.
struct TeGlState {
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

  bool operator==(const TeGlState& other) const { return std::memcmp(this, &other, sizeof *this) == 0; }
};

/// Puts OpenGL into a state that is not the usual one, and looks at what is left of it: to be put around a
/// mesh.
class TeGlNeighbour {
public:
  explicit TeGlNeighbour(const TeContext& context) : m_gl(context.gl()) {
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
        static_cast<TeGlNeighbour*>(self)->bind();
    });
  }
  TeNodePtr<SoCallback> after() {
    return callback([](void* self, SoAction* action) {
      if (action->isOfType(SoGLRenderAction::getClassTypeId()))
        static_cast<TeGlNeighbour*>(self)->unbind();
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

  TeGlState look() const {
    TeGlState state;
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
  TeGlState m_before;
};
