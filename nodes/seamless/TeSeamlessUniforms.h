#pragma once

#include "nodes/seamless/TeSeamlessFrame.h"
#include "nodes/seamless/TeSeamlessLayout.h"
#include "nodes/seamless/TeSeamlessLook.h"
#include "nodes/seamless/TeSeamlessPrograms.h"

/// Gives a program, which is in use, what it must know of a frame.
class TeSeamlessUniforms {
public:
  TeSeamlessUniforms(const TeSeamlessGl& gl, const TeSeamlessProgram& program)
      : m_gl(gl), m_program(program) {}

  void setFrame(const TeSeamlessFrame& frame, const TeSeamlessLayout& layout) const;
  /// `slopeUnit`: TeSeamlessTextures::slopeUnit().
  void setLook(const TeSeamlessLook& look, float slopeUnit) const;

private:
  void setHeightClipmap(const TeSeamlessClipTexture& clipmap) const;
  void setColourClipmap(const TeSeamlessClipTexture& clipmap) const;

  const TeSeamlessGl& m_gl;
  const TeSeamlessProgram& m_program;
};
