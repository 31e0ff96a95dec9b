#pragma once

#include "generators/base/TeResult.h"

#include <GL/gl.h>

#include <functional>

/// The OpenGL functions that Terrane itself calls. The libraries import no gl* symbol, so that the context
/// decides who provides them, whatever else is loaded.
struct TeGlTable {
  const GLubyte* (*getString)(GLenum) = nullptr;
  GLenum (*getError)() = nullptr;
  void (*getIntegerv)(GLenum, GLint*) = nullptr;
  void (*enable)(GLenum) = nullptr;
  void (*disable)(GLenum) = nullptr;
  void (*clearColor)(GLfloat, GLfloat, GLfloat, GLfloat) = nullptr;
  void (*clearDepth)(GLdouble) = nullptr;
  void (*clear)(GLbitfield) = nullptr;
  void (*viewport)(GLint, GLint, GLsizei, GLsizei) = nullptr;
  void (*finish)() = nullptr;
  void (*pixelStorei)(GLenum, GLint) = nullptr;
  void (*readPixels)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*) = nullptr;
  void (*genFramebuffers)(GLsizei, GLuint*) = nullptr;
  void (*deleteFramebuffers)(GLsizei, const GLuint*) = nullptr;
  void (*bindFramebuffer)(GLenum, GLuint) = nullptr;
  GLenum (*checkFramebufferStatus)(GLenum) = nullptr;
  void (*framebufferRenderbuffer)(GLenum, GLenum, GLenum, GLuint) = nullptr;
  void (*blitFramebuffer)(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield,
                          GLenum) = nullptr;
  void (*genRenderbuffers)(GLsizei, GLuint*) = nullptr;
  void (*deleteRenderbuffers)(GLsizei, const GLuint*) = nullptr;
  void (*bindRenderbuffer)(GLenum, GLuint) = nullptr;
  void (*renderbufferStorageMultisample)(GLenum, GLsizei, GLenum, GLsizei, GLsizei) = nullptr;

  /// Fills the table. Error: a function is missing (OpenGL before 3.0); the message names it.
  static TeResult<TeGlTable> load(const std::function<void*(const char*)>& procAddress);
};
