#pragma once

#include "nodes/terrain/TeMeshGl.h"

/// The OpenGL functions that TeLodSender needs beside those of meshes.
struct TeLodGl : TeMeshGl {
  void (*getIntegerv)(GLenum, GLint*) = nullptr;
  void (*getFloatv)(GLenum, GLfloat*) = nullptr;
  void (*matrixMode)(GLenum) = nullptr;
  void (*loadMatrixf)(const GLfloat*) = nullptr;
  void (*loadMatrixd)(const GLdouble*) = nullptr;
  void (*polygonMode)(GLenum, GLenum) = nullptr;
  void (*bufferSubData)(GLenum, GLintptr, GLsizeiptr, const void*) = nullptr;
  void (*drawArrays)(GLenum, GLint, GLsizei) = nullptr;
  void (*begin)(GLenum) = nullptr;
  void (*end)() = nullptr;
  void (*vertex3fv)(const GLfloat*) = nullptr;
  void (*normal3sv)(const GLshort*) = nullptr;
  void (*color4ubv)(const GLubyte*) = nullptr;
  GLuint (*genLists)(GLsizei) = nullptr;
  void (*newList)(GLuint, GLenum) = nullptr;
  void (*endList)() = nullptr;
  void (*callList)(GLuint) = nullptr;
  void (*deleteLists)(GLuint, GLsizei) = nullptr;

  /// Functions of the current context. False, after a line in TeLog: OpenGL before 1.5, or a core profile.
  bool load(std::uint32_t context);
};
