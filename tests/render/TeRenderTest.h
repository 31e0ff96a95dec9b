#pragma once

#include "nodes/TeSceneRenderer.h"
#include "nodes/context/TeContext.h"

#include <gtest/gtest.h>

#include <memory>

class SoNode;

/// A test that draws with the context that the test program was started with (--context).
class TeRenderTest : public testing::Test {
public:
  static TeContextKind s_kind;
  /// Pictures are kept in this folder for people to look at; none are if it is empty (--pictures FOLDER).
  static std::string s_folder;

protected:
  void SetUp() override;

  TeContext& context() { return *m_context; }
  /// Draws one frame; fails the test and gives an empty picture on an error. Keeps the picture by name,
  /// if it has one.
  TePicture draw(SoNode* scene, int width, int height, const std::string& name = "",
                 const SbColor& background = SbColor(1, 0, 1));

private:
  std::unique_ptr<TeContext> m_context;
};
