#pragma once

#include "nodes/context/TeContext.h"

#include <GL/gl.h>

#include <gtest/gtest.h>

/// Textures, buffers, programs, display lists and the like that a context has, which is current.
inline int glObjects(const TeContext& context) {
  int count = 0;
  for (const char* name : {"glIsTexture", "glIsBuffer", "glIsProgram", "glIsShader", "glIsVertexArray",
                           "glIsSampler", "glIsQuery", "glIsTransformFeedback", "glIsList"}) {
    const auto isObject = reinterpret_cast<GLboolean (*)(GLuint)>(context.procAddress(name));
    EXPECT_TRUE(isObject) << name;
    for (GLuint i = 1; i < 2000; i++)
      count += isObject(i);
  }
  return count;
}
