#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

/// The OpenGL functions that meshes are drawn with, found by the number under which Coin knows the context:
/// a node is drawn in contexts of programs that know nothing of TeContext.
struct TeMeshGl {
  void (*genBuffers)(GLsizei, GLuint*) = nullptr;
  void (*deleteBuffers)(GLsizei, const GLuint*) = nullptr;
  void (*bindBuffer)(GLenum, GLuint) = nullptr;
  void (*bufferData)(GLenum, GLsizeiptr, const void*, GLenum) = nullptr;
  void (*pushClientAttrib)(GLbitfield) = nullptr;
  void (*popClientAttrib)() = nullptr;
  void (*enableClientState)(GLenum) = nullptr;
  void (*disableClientState)(GLenum) = nullptr;
  void (*vertexPointer)(GLint, GLenum, GLsizei, const void*) = nullptr;
  void (*normalPointer)(GLenum, GLsizei, const void*) = nullptr;
  void (*colorPointer)(GLint, GLenum, GLsizei, const void*) = nullptr;
  void (*drawElements)(GLenum, GLsizei, GLenum, const void*) = nullptr;
  /// Null before OpenGL 3.0, which has no vertex array objects.
  void (*bindVertexArray)(GLuint) = nullptr;

  /// Functions of the current context. False, after a line in TeLog: OpenGL before 1.5, or a core profile.
  bool load(std::uint32_t context);
};
