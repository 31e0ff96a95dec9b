#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <functional>

/// The OpenGL functions that Seamless Patches are drawn with, found by the number under which Coin knows the
/// context: OpenGL 3.3, compatibility profile.
struct TeSeamlessGl {
  // OpenGL 1.1
  void (*enable)(GLenum) = nullptr;
  void (*disable)(GLenum) = nullptr;
  GLboolean (*isEnabled)(GLenum) = nullptr;
  GLenum (*getError)() = nullptr;
  void (*getIntegerv)(GLenum, GLint*) = nullptr;
  void (*getFloatv)(GLenum, GLfloat*) = nullptr;
  void (*getLightfv)(GLenum, GLenum, GLfloat*) = nullptr;
  void (*getMaterialfv)(GLenum, GLenum, GLfloat*) = nullptr;
  void (*polygonMode)(GLenum, GLenum) = nullptr;
  void (*pushClientAttrib)(GLbitfield) = nullptr;
  void (*popClientAttrib)() = nullptr;
  void (*pixelStorei)(GLenum, GLint) = nullptr;
  void (*genTextures)(GLsizei, GLuint*) = nullptr;
  void (*deleteTextures)(GLsizei, const GLuint*) = nullptr;
  void (*bindTexture)(GLenum, GLuint) = nullptr;
  void (*texParameteri)(GLenum, GLenum, GLint) = nullptr;
  void (*texImage2D)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) = nullptr;
  void (*texSubImage2D)(GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, const void*) = nullptr;
  // to 3.3
  PFNGLACTIVETEXTUREPROC activeTexture = nullptr;
  PFNGLGENERATEMIPMAPPROC generateMipmap = nullptr;
  PFNGLBINDSAMPLERPROC bindSampler = nullptr;
  PFNGLGENSAMPLERSPROC genSamplers = nullptr;
  PFNGLDELETESAMPLERSPROC deleteSamplers = nullptr;
  PFNGLSAMPLERPARAMETERIPROC samplerParameteri = nullptr;
  PFNGLGENBUFFERSPROC genBuffers = nullptr;
  PFNGLDELETEBUFFERSPROC deleteBuffers = nullptr;
  PFNGLBINDBUFFERPROC bindBuffer = nullptr;
  PFNGLBINDBUFFERBASEPROC bindBufferBase = nullptr;
  PFNGLBUFFERDATAPROC bufferData = nullptr;
  PFNGLGETBUFFERSUBDATAPROC getBufferSubData = nullptr;
  PFNGLGENVERTEXARRAYSPROC genVertexArrays = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC deleteVertexArrays = nullptr;
  PFNGLBINDVERTEXARRAYPROC bindVertexArray = nullptr;
  PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray = nullptr;
  PFNGLVERTEXATTRIBIPOINTERPROC vertexAttribIPointer = nullptr;
  PFNGLVERTEXATTRIBDIVISORPROC vertexAttribDivisor = nullptr;
  PFNGLVERTEXATTRIBI4IPROC vertexAttribI4i = nullptr;
  PFNGLVERTEXATTRIB4FVPROC vertexAttrib4fv = nullptr;
  PFNGLGETVERTEXATTRIBFVPROC getVertexAttribfv = nullptr;
  PFNGLDRAWELEMENTSBASEVERTEXPROC drawElementsBaseVertex = nullptr;
  PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC drawElementsInstancedBaseVertex = nullptr;
  PFNGLCREATESHADERPROC createShader = nullptr;
  PFNGLDELETESHADERPROC deleteShader = nullptr;
  PFNGLSHADERSOURCEPROC shaderSource = nullptr;
  PFNGLCOMPILESHADERPROC compileShader = nullptr;
  PFNGLGETSHADERIVPROC getShaderiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC getShaderInfoLog = nullptr;
  PFNGLCREATEPROGRAMPROC createProgram = nullptr;
  PFNGLDELETEPROGRAMPROC deleteProgram = nullptr;
  PFNGLATTACHSHADERPROC attachShader = nullptr;
  PFNGLLINKPROGRAMPROC linkProgram = nullptr;
  PFNGLGETPROGRAMIVPROC getProgramiv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog = nullptr;
  PFNGLUSEPROGRAMPROC useProgram = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC getUniformLocation = nullptr;
  PFNGLUNIFORM1IPROC uniform1i = nullptr;
  PFNGLUNIFORM2IPROC uniform2i = nullptr;
  PFNGLUNIFORM4IPROC uniform4i = nullptr;
  PFNGLUNIFORM4IVPROC uniform4iv = nullptr;
  PFNGLUNIFORM1FPROC uniform1f = nullptr;
  PFNGLUNIFORM2FPROC uniform2f = nullptr;
  PFNGLUNIFORM4FVPROC uniform4fv = nullptr;
  PFNGLUNIFORMMATRIX3FVPROC uniformMatrix3fv = nullptr;
  PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv = nullptr;
  PFNGLTRANSFORMFEEDBACKVARYINGSPROC transformFeedbackVaryings = nullptr;
  PFNGLBEGINTRANSFORMFEEDBACKPROC beginTransformFeedback = nullptr;
  PFNGLENDTRANSFORMFEEDBACKPROC endTransformFeedback = nullptr;
  /// OpenGL 4.2; null before.
  PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCEPROC drawElementsInstancedBaseVertexBaseInstance = nullptr;

  /// Functions of the current context. False, after a line in TeLog: OpenGL before 3.3.
  bool load(std::uint32_t context);
  /// Those that `procAddress` gives by name. False, after a line in TeLog: one is missing.
  bool load(const std::function<void*(const char*)>& procAddress);
};
