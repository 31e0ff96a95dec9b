#pragma once

#include "nodes/seamless/TeSeamlessGl.h"
#include "nodes/seamless/TeSeamlessShader.h"
#include "nodes/seamless/TeSeamlessVariant.h"

#include <glm/vec4.hpp>

/// Keeps the state of OpenGL that drawing Seamless Patches changes, and puts it back when it goes. While it
/// lives, texture unit 0 is active and an empty vertex array object bound, which goes with it: Coin takes
/// contexts that share objects for one, but these share no vertex array objects.
class TeSeamlessGlState {
public:
  explicit TeSeamlessGlState(const TeSeamlessGl& gl);
  ~TeSeamlessGlState();
  TeSeamlessGlState(const TeSeamlessGlState&) = delete;
  TeSeamlessGlState& operator=(const TeSeamlessGlState&) = delete;

  /// What the lights, material, fog and clip planes of OpenGL call for.
  void describe(TeSeamlessVariant& variant) const;
  /// Diffuse colour and alpha of the material.
  glm::vec4 material() const;

private:
  struct Unit {
    GLint texture = 0;
    GLint textureArray = 0;
    GLint sampler = 0;
  };

  GLint integer(GLenum name) const;
  TeSeamlessVariant::Light lightKind(int number) const;

  const TeSeamlessGl& m_gl;
  GLint m_program;
  GLint m_vertexArray;
  GLint m_arrayBuffer;
  GLint m_activeTexture;
  GLint m_polygonModes[2] = {};
  GLboolean m_restartsPrimitives;
  GLfloat m_instance[4] = {}; ///< attribute
  Unit m_units[TeSeamlessShader::kUnits];
  GLuint m_ownVertexArray = 0;
};
