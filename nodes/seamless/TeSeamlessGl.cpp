#include "nodes/seamless/TeSeamlessGl.h"

#include "generators/base/TeLog.h"
#include "nodes/context/TeGlLoader.h"

#include <Inventor/C/glue/gl.h>

bool TeSeamlessGl::load(std::uint32_t context) {
  const cc_glglue* glue = cc_glglue_instance(int(context));
  // Libraries give the addresses of functions that a context cannot use.
  if (!cc_glglue_glversion_matches_at_least(glue, 3, 3, 0)) {
    TeLog::error("seamless patches are not drawn: OpenGL is older than 3.3");
    return false;
  }
  const bool isComplete = load([&](const char* name) { return cc_glglue_getprocaddress(glue, name); });
  if (!cc_glglue_glversion_matches_at_least(glue, 4, 2, 0))
    drawElementsInstancedBaseVertexBaseInstance = nullptr;
  return isComplete;
}

bool TeSeamlessGl::load(const std::function<void*(const char*)>& procAddress) {
  TeGlLoader gl(procAddress);
  gl.need("glEnable", enable);
  gl.need("glDisable", disable);
  gl.need("glIsEnabled", isEnabled);
  gl.need("glGetError", getError);
  gl.need("glGetIntegerv", getIntegerv);
  gl.need("glGetFloatv", getFloatv);
  gl.need("glGetLightfv", getLightfv);
  gl.need("glGetMaterialfv", getMaterialfv);
  gl.need("glPolygonMode", polygonMode);
  gl.need("glPushClientAttrib", pushClientAttrib);
  gl.need("glPopClientAttrib", popClientAttrib);
  gl.need("glPixelStorei", pixelStorei);
  gl.need("glGenTextures", genTextures);
  gl.need("glDeleteTextures", deleteTextures);
  gl.need("glBindTexture", bindTexture);
  gl.need("glTexParameteri", texParameteri);
  gl.need("glTexImage2D", texImage2D);
  gl.need("glTexSubImage2D", texSubImage2D);
  gl.need("glActiveTexture", activeTexture);
  gl.need("glGenerateMipmap", generateMipmap);
  gl.need("glBindSampler", bindSampler);
  gl.need("glGenSamplers", genSamplers);
  gl.need("glDeleteSamplers", deleteSamplers);
  gl.need("glSamplerParameteri", samplerParameteri);
  gl.need("glGenBuffers", genBuffers);
  gl.need("glDeleteBuffers", deleteBuffers);
  gl.need("glBindBuffer", bindBuffer);
  gl.need("glBindBufferBase", bindBufferBase);
  gl.need("glBufferData", bufferData);
  gl.need("glGetBufferSubData", getBufferSubData);
  gl.need("glGenVertexArrays", genVertexArrays);
  gl.need("glDeleteVertexArrays", deleteVertexArrays);
  gl.need("glBindVertexArray", bindVertexArray);
  gl.need("glEnableVertexAttribArray", enableVertexAttribArray);
  gl.need("glVertexAttribIPointer", vertexAttribIPointer);
  gl.need("glVertexAttribDivisor", vertexAttribDivisor);
  gl.need("glVertexAttribI4i", vertexAttribI4i);
  gl.need("glVertexAttrib4fv", vertexAttrib4fv);
  gl.need("glGetVertexAttribfv", getVertexAttribfv);
  gl.need("glDrawElementsBaseVertex", drawElementsBaseVertex);
  gl.need("glDrawElementsInstancedBaseVertex", drawElementsInstancedBaseVertex);
  gl.need("glCreateShader", createShader);
  gl.need("glDeleteShader", deleteShader);
  gl.need("glShaderSource", shaderSource);
  gl.need("glCompileShader", compileShader);
  gl.need("glGetShaderiv", getShaderiv);
  gl.need("glGetShaderInfoLog", getShaderInfoLog);
  gl.need("glCreateProgram", createProgram);
  gl.need("glDeleteProgram", deleteProgram);
  gl.need("glAttachShader", attachShader);
  gl.need("glLinkProgram", linkProgram);
  gl.need("glGetProgramiv", getProgramiv);
  gl.need("glGetProgramInfoLog", getProgramInfoLog);
  gl.need("glUseProgram", useProgram);
  gl.need("glGetUniformLocation", getUniformLocation);
  gl.need("glUniform1i", uniform1i);
  gl.need("glUniform2i", uniform2i);
  gl.need("glUniform4i", uniform4i);
  gl.need("glUniform4iv", uniform4iv);
  gl.need("glUniform1f", uniform1f);
  gl.need("glUniform2f", uniform2f);
  gl.need("glUniform4fv", uniform4fv);
  gl.need("glUniformMatrix3fv", uniformMatrix3fv);
  gl.need("glUniformMatrix4fv", uniformMatrix4fv);
  gl.need("glTransformFeedbackVaryings", transformFeedbackVaryings);
  gl.need("glBeginTransformFeedback", beginTransformFeedback);
  gl.need("glEndTransformFeedback", endTransformFeedback);
  gl.find("glDrawElementsInstancedBaseVertexBaseInstance", drawElementsInstancedBaseVertexBaseInstance);
  return gl.isComplete("seamless patches are not drawn");
}
