#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/seamless/TeSeamlessContent.h"
#include "nodes/seamless/TeSeamlessLook.h"

#include <Inventor/nodes/SoCamera.h>

#include <memory>

/// Seamless Patches ready to be seen.
struct TeSeamlessScene {
  TeSeamlessContent content;
  TeSeamlessPlacement placement;
  TeSeamlessAccuracy accuracy; ///< before SoComplexity
  TeSeamlessLook look;
  bool wholePatches = false;                   ///< drawn at once, not by tiles and strips
  TeNodePtr<SoTeClipmap> colours;              ///< in place of the look's texture; null: none
  std::shared_ptr<TePyramidTiles> colourTiles; ///< that `colours` had
  TeNodePtr<SoCamera> lodCamera;               ///< null: the one that draws
};
