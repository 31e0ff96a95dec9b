#include "nodes/seamless/TeSeamlessGlState.h"

TeSeamlessGlState::TeSeamlessGlState(const TeSeamlessGl& gl)
    : m_gl(gl), m_program(integer(GL_CURRENT_PROGRAM)), m_vertexArray(integer(GL_VERTEX_ARRAY_BINDING)),
      m_arrayBuffer(integer(GL_ARRAY_BUFFER_BINDING)), m_activeTexture(integer(GL_ACTIVE_TEXTURE)),
      m_restartsPrimitives(gl.isEnabled(GL_PRIMITIVE_RESTART)) {
  gl.getIntegerv(GL_POLYGON_MODE, m_polygonModes);
  gl.getVertexAttribfv(TeSeamlessShader::kInstanceAttribute, GL_CURRENT_VERTEX_ATTRIB, m_instance);
  for (int i = TeSeamlessShader::kUnits - 1; i >= 0; i--) {
    gl.activeTexture(GLenum(GL_TEXTURE0 + i));
    m_units[i] = {integer(GL_TEXTURE_BINDING_2D), integer(GL_TEXTURE_BINDING_2D_ARRAY),
                  integer(GL_SAMPLER_BINDING)};
  }
  if (m_restartsPrimitives)
    gl.disable(GL_PRIMITIVE_RESTART);
  gl.genVertexArrays(1, &m_ownVertexArray);
  gl.bindVertexArray(m_ownVertexArray);
}

TeSeamlessGlState::~TeSeamlessGlState() {
  m_gl.bindVertexArray(GLuint(m_vertexArray));
  m_gl.deleteVertexArrays(1, &m_ownVertexArray);
  m_gl.bindBuffer(GL_ARRAY_BUFFER, GLuint(m_arrayBuffer));
  m_gl.useProgram(GLuint(m_program));
  for (int i = 0; i < TeSeamlessShader::kUnits; i++) {
    m_gl.activeTexture(GLenum(GL_TEXTURE0 + i));
    m_gl.bindTexture(GL_TEXTURE_2D, GLuint(m_units[i].texture));
    m_gl.bindTexture(GL_TEXTURE_2D_ARRAY, GLuint(m_units[i].textureArray));
    m_gl.bindSampler(GLuint(i), GLuint(m_units[i].sampler));
  }
  m_gl.activeTexture(GLenum(m_activeTexture));
  m_gl.vertexAttrib4fv(TeSeamlessShader::kInstanceAttribute, m_instance);
  m_gl.polygonMode(GL_FRONT, GLenum(m_polygonModes[0]));
  m_gl.polygonMode(GL_BACK, GLenum(m_polygonModes[1]));
  if (m_restartsPrimitives)
    m_gl.enable(GL_PRIMITIVE_RESTART);
}

GLint TeSeamlessGlState::integer(GLenum name) const {
  GLint value = 0;
  m_gl.getIntegerv(name, &value);
  return value;
}

TeSeamlessVariant::Light TeSeamlessGlState::lightKind(int number) const {
  const GLenum light = GLenum(GL_LIGHT0 + number);
  if (!m_gl.isEnabled(light))
    return TeSeamlessVariant::None;
  GLfloat position[4] = {};
  m_gl.getLightfv(light, GL_POSITION, position);
  if (position[3] == 0)
    return TeSeamlessVariant::Directional;
  GLfloat cutoff = 180;
  m_gl.getLightfv(light, GL_SPOT_CUTOFF, &cutoff);
  return cutoff == 180 ? TeSeamlessVariant::Point : TeSeamlessVariant::Spot;
}

void TeSeamlessGlState::describe(TeSeamlessVariant& variant) const {
  variant.isLit = m_gl.isEnabled(GL_LIGHTING);
  if (variant.isLit) {
    for (int i = 0; i < TeSeamlessVariant::kMaxLights; i++)
      variant.lights = std::uint16_t(variant.lights | lightKind(i) << (2 * i));
    GLfloat specular[4] = {};
    m_gl.getMaterialfv(GL_FRONT, GL_SPECULAR, specular);
    variant.hasGloss = specular[0] > 0 || specular[1] > 0 || specular[2] > 0;
    variant.isTwoSided = integer(GL_LIGHT_MODEL_TWO_SIDE) != 0;
  }
  if (m_gl.isEnabled(GL_FOG)) {
    const GLint mode = integer(GL_FOG_MODE);
    variant.fog = mode == GL_LINEAR ? TeSeamlessVariant::Linear
                  : mode == GL_EXP  ? TeSeamlessVariant::Exp
                                    : TeSeamlessVariant::Exp2;
  }
  const GLint planes = integer(GL_MAX_CLIP_PLANES);
  for (GLint i = 0; i < planes && !variant.isClipped; i++)
    variant.isClipped = m_gl.isEnabled(GLenum(GL_CLIP_PLANE0 + i));
}

glm::vec4 TeSeamlessGlState::material() const {
  GLfloat colour[4] = {};
  m_gl.getFloatv(GL_CURRENT_COLOR, colour);
  return {colour[0], colour[1], colour[2], colour[3]};
}
