#pragma once

#include "generators/base/TeResult.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

/// The OpenGL functions of a clipmap's texture, found by the number under which Coin knows the context.
struct TeClipmapGl {
  void (*genTextures)(GLsizei, GLuint*) = nullptr;
  void (*deleteTextures)(GLsizei, const GLuint*) = nullptr;
  void (*bindTexture)(GLenum, GLuint) = nullptr;
  void (*bindBuffer)(GLenum, GLuint) = nullptr;
  void (*texImage3D)(GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum,
                     const void*) = nullptr;
  void (*texSubImage3D)(GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum,
                        const void*) = nullptr;
  void (*texParameteri)(GLenum, GLenum, GLint) = nullptr;
  void (*pixelStorei)(GLenum, GLint) = nullptr;
  void (*getIntegerv)(GLenum, GLint*) = nullptr;
  GLenum (*getError)() = nullptr;

  /// Functions of the current context. Error: OpenGL before 3.0.
  TeStatus load(std::uint32_t context);
};
