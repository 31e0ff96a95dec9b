#pragma once

#include "nodes/clipmap/TeClipResidency.h"

#include <GL/gl.h>

/// What the shaders must know of a clipmap in one context: a texture array whose layer i has the window of
/// level base + i of a pyramid, sample (x, y) of the level at texel (x mod clipSize, y mod clipSize).
struct TeSeamlessClipTexture {
  enum Format {
    Short, ///< R16UI, in the unit of the samples
    Half,  ///< R16F, 0 .. 1 for 0 .. 65535
    Float, ///< R32F, in the unit of the samples
    Colour ///< RGBA8; a colour pyramid
  };
  /// Levels of a pyramid that a texture may have.
  static constexpr int kMaxLevels = 23;

  GLuint texture = 0;
  Format format = Short;
  int clipSize = 0;
  /// Of the pyramid's finest level: 2^resolutionLog + 1 samples a side. For heights that of the layout.
  int resolutionLog = 0;
  TeClipResidency residency;
};
