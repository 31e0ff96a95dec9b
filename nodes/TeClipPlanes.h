#pragma once

#include "generators/base/TeResult.h"

class SbViewportRegion;
class SoNode;

/// Sets near and far of the first camera in a scene so that they enclose all of it, without notifying
/// anyone. (Coin's own choice has been seen to cut away what was close.) A perspective camera's near is at
/// least its far / 10000, so that 24 bits of depth tell surfaces apart; an empty scene changes nothing.
/// Error: no camera.
TeStatus teFitClipPlanes(SoNode* scene, const SbViewportRegion& viewport);
