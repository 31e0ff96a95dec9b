#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/TePicture.h"
#include "nodes/TeSurfaceColours.h"
#include "nodes/terrain/TeStaticBlock.h"

#include <Inventor/nodes/SoSeparator.h>

#include <optional>

/// How a block is drawn.
struct TeBlockStyle {
  /// By default fitted to the block's range of heights.
  std::optional<TeSurfaceColours> colours;
  /// Patches, seams and corners each in one colour instead.
  bool showParts = false;
  /// Draped over all patches of the block instead of colours; north is up.
  std::optional<TePicture> image;
  /// Level of a sheet of water, metres.
  std::optional<float> water;
  /// Heights are drawn this many times as high.
  float verticalScale = 1;
};

/// The scene graph of a block, of Coin's own nodes alone: the block's centre is the scene's (0, 0), x east,
/// y north, z up from height 0. No camera, no light. Error: an image that cannot be draped, a vertical scale
/// that is not finite and positive.
TeResult<TeNodePtr<SoSeparator>> teBlockGraph(const TeStaticBlock& block, const TeBlockStyle& style = {});
