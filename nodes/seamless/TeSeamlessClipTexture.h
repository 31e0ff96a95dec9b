#pragma once

#include "nodes/clipmap/TeClipFormat.h"
#include "nodes/clipmap/TeClipResidency.h"
#include "nodes/clipmap/TeClipWindows.h"
#include "nodes/clipmap/TeClipmapTexture.h"

/// What the shaders must know of a clipmap in one context: a texture array whose layer i has the window of
/// level base + i of a pyramid, sample (x, y) of the level at texel (x mod clipSize, y mod clipSize).
struct TeSeamlessClipTexture {
  /// Levels of a pyramid that a texture may have.
  static constexpr int kMaxLevels = 23;

  GLuint texture = 0;
  TeClipFormat format = TeClipFormat::Short;
  int clipSize = 0;
  /// Of the pyramid's finest level: 2^resolutionLog + 1 samples a side. For heights that of the layout, also
  /// where the pyramid's finest level is not as fine.
  int resolutionLog = 0;
  TeClipResidency residency;

  /// After the texture was updated from the windows.
  static TeSeamlessClipTexture of(const TeClipmapTexture& texture, const TeClipWindows& windows,
                                  int resolutionLog) {
    return {texture.name(), texture.format(), windows.side(), resolutionLog, windows.residency()};
  }
};
