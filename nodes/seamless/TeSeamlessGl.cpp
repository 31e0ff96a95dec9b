#include "nodes/seamless/TeSeamlessGl.h"

#include "generators/base/TeLog.h"

#include <Inventor/C/glue/gl.h>

#include <string>
#include <type_traits>

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
  const char* missing = nullptr;
  const auto find = [&](const char* name, auto*& function) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(procAddress(name));
    return function != nullptr;
  };
  const auto need = [&](const char* name, auto*& function) {
    if (!find(name, function) && !missing)
      missing = name;
  };
  need("glEnable", enable);
  need("glDisable", disable);
  need("glIsEnabled", isEnabled);
  need("glGetError", getError);
  need("glGetIntegerv", getIntegerv);
  need("glGetFloatv", getFloatv);
  need("glGetLightfv", getLightfv);
  need("glGetMaterialfv", getMaterialfv);
  need("glPolygonMode", polygonMode);
  need("glPushClientAttrib", pushClientAttrib);
  need("glPopClientAttrib", popClientAttrib);
  need("glPixelStorei", pixelStorei);
  need("glGenTextures", genTextures);
  need("glDeleteTextures", deleteTextures);
  need("glBindTexture", bindTexture);
  need("glTexParameteri", texParameteri);
  need("glTexImage2D", texImage2D);
  need("glTexSubImage2D", texSubImage2D);
  need("glActiveTexture", activeTexture);
  need("glGenerateMipmap", generateMipmap);
  need("glBindSampler", bindSampler);
  need("glGenSamplers", genSamplers);
  need("glDeleteSamplers", deleteSamplers);
  need("glSamplerParameteri", samplerParameteri);
  need("glGenBuffers", genBuffers);
  need("glDeleteBuffers", deleteBuffers);
  need("glBindBuffer", bindBuffer);
  need("glBindBufferBase", bindBufferBase);
  need("glBufferData", bufferData);
  need("glGetBufferSubData", getBufferSubData);
  need("glGenVertexArrays", genVertexArrays);
  need("glDeleteVertexArrays", deleteVertexArrays);
  need("glBindVertexArray", bindVertexArray);
  need("glEnableVertexAttribArray", enableVertexAttribArray);
  need("glVertexAttribIPointer", vertexAttribIPointer);
  need("glVertexAttribDivisor", vertexAttribDivisor);
  need("glVertexAttribI4i", vertexAttribI4i);
  need("glVertexAttrib4fv", vertexAttrib4fv);
  need("glGetVertexAttribfv", getVertexAttribfv);
  need("glDrawElementsBaseVertex", drawElementsBaseVertex);
  need("glDrawElementsInstancedBaseVertex", drawElementsInstancedBaseVertex);
  need("glCreateShader", createShader);
  need("glDeleteShader", deleteShader);
  need("glShaderSource", shaderSource);
  need("glCompileShader", compileShader);
  need("glGetShaderiv", getShaderiv);
  need("glGetShaderInfoLog", getShaderInfoLog);
  need("glCreateProgram", createProgram);
  need("glDeleteProgram", deleteProgram);
  need("glAttachShader", attachShader);
  need("glLinkProgram", linkProgram);
  need("glGetProgramiv", getProgramiv);
  need("glGetProgramInfoLog", getProgramInfoLog);
  need("glUseProgram", useProgram);
  need("glGetUniformLocation", getUniformLocation);
  need("glUniform1i", uniform1i);
  need("glUniform2i", uniform2i);
  need("glUniform4i", uniform4i);
  need("glUniform4iv", uniform4iv);
  need("glUniform1f", uniform1f);
  need("glUniform2f", uniform2f);
  need("glUniform4fv", uniform4fv);
  need("glUniformMatrix3fv", uniformMatrix3fv);
  need("glUniformMatrix4fv", uniformMatrix4fv);
  need("glTransformFeedbackVaryings", transformFeedbackVaryings);
  need("glBeginTransformFeedback", beginTransformFeedback);
  need("glEndTransformFeedback", endTransformFeedback);
  find("glDrawElementsInstancedBaseVertexBaseInstance", drawElementsInstancedBaseVertexBaseInstance);
  if (missing)
    TeLog::error(std::string("seamless patches are not drawn: OpenGL lacks ") + missing);
  return !missing;
}
