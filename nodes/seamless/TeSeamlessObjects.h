#pragma once

#include "nodes/seamless/TeSeamlessGl.h"

#include <cstdint>
#include <vector>

/// The OpenGL objects of one TeSeamlessRenderer: what is made here goes with removeAll(). All calls but
/// live() with the context current.
class TeSeamlessObjects {
public:
  explicit TeSeamlessObjects(const TeSeamlessGl& gl) : m_gl(gl) {}
  TeSeamlessObjects(const TeSeamlessObjects&) = delete;
  TeSeamlessObjects& operator=(const TeSeamlessObjects&) = delete;

  GLuint addBuffer();
  GLuint addTexture();
  GLuint addSampler();
  /// 0 if OpenGL makes none.
  GLuint addProgram();
  void removeTexture(GLuint texture);
  void removeProgram(GLuint program);
  void removeAll();

  /// In all contexts together; for tests of leaks.
  static std::int64_t live();

private:
  const TeSeamlessGl& m_gl;
  std::vector<GLuint> m_buffers;
  std::vector<GLuint> m_textures;
  std::vector<GLuint> m_samplers;
  std::vector<GLuint> m_programs;
};
