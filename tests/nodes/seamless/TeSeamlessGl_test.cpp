#include "nodes/seamless/TeSeamlessGl.h"

#include "nodes/logLines.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

void someFunction() {}

} // namespace

TEST(TeSeamlessGl, AMissingFunctionIsOneLineThatNamesIt) {
  for (const std::string lacking :
       {"glEnable", "glDrawElementsInstancedBaseVertex", "glEndTransformFeedback"}) {
    LogLines log;
    TeSeamlessGl gl;
    EXPECT_FALSE(gl.load([&](const char* name) {
      return name == lacking ? nullptr : reinterpret_cast<void*>(&someFunction);
    }));
    EXPECT_EQ(log.lines, std::vector<std::string>{"seamless patches are not drawn: OpenGL lacks " + lacking});
  }
}

TEST(TeSeamlessGl, WhatOpenGl42AddsIsNotNeeded) {
  LogLines log;
  TeSeamlessGl gl;
  EXPECT_TRUE(gl.load([](const char* name) {
    return std::string(name) == "glDrawElementsInstancedBaseVertexBaseInstance"
               ? nullptr
               : reinterpret_cast<void*>(&someFunction);
  }));
  EXPECT_EQ(gl.drawElementsInstancedBaseVertexBaseInstance, nullptr);
  EXPECT_TRUE(log.lines.empty());
}
