#include "nodes/seamless/TeSeamlessObjects.h"

#include <algorithm>

namespace {

std::int64_t liveCount = 0; ///< OpenGL is used by one thread only

GLuint keep(std::vector<GLuint>& names, GLuint name) {
  names.push_back(name);
  liveCount++;
  return name;
}

bool drop(std::vector<GLuint>& names, GLuint name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    return false;
  names.erase(found);
  liveCount--;
  return true;
}

} // namespace

std::int64_t TeSeamlessObjects::live() { return liveCount; }

GLuint TeSeamlessObjects::addBuffer() {
  GLuint name = 0;
  m_gl.genBuffers(1, &name);
  return keep(m_buffers, name);
}

GLuint TeSeamlessObjects::addTexture() {
  GLuint name = 0;
  m_gl.genTextures(1, &name);
  return keep(m_textures, name);
}

GLuint TeSeamlessObjects::addSampler() {
  GLuint name = 0;
  m_gl.genSamplers(1, &name);
  return keep(m_samplers, name);
}

GLuint TeSeamlessObjects::addProgram() {
  const GLuint name = m_gl.createProgram();
  return name ? keep(m_programs, name) : 0;
}

void TeSeamlessObjects::removeTexture(GLuint texture) {
  if (drop(m_textures, texture))
    m_gl.deleteTextures(1, &texture);
}

void TeSeamlessObjects::removeProgram(GLuint program) {
  if (drop(m_programs, program))
    m_gl.deleteProgram(program);
}

void TeSeamlessObjects::removeAll() {
  liveCount -= std::int64_t(m_buffers.size() + m_textures.size() + m_samplers.size() + m_programs.size());
  if (!m_buffers.empty())
    m_gl.deleteBuffers(GLsizei(m_buffers.size()), m_buffers.data());
  if (!m_textures.empty())
    m_gl.deleteTextures(GLsizei(m_textures.size()), m_textures.data());
  if (!m_samplers.empty())
    m_gl.deleteSamplers(GLsizei(m_samplers.size()), m_samplers.data());
  for (const GLuint program : m_programs)
    m_gl.deleteProgram(program);
  m_buffers.clear();
  m_textures.clear();
  m_samplers.clear();
  m_programs.clear();
}
