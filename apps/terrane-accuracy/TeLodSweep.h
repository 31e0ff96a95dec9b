#pragma once

#include "apps/terrane-accuracy/TeFlightStage.h"
#include "apps/terrane-accuracy/TeLodCandidate.h"
#include "apps/terrane-accuracy/TeMeasuredErrors.h"
#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "apps/terrane-accuracy/TeSpread.h"

#include <functional>

/// One method at one accuracy over a flight.
struct TeLodFigures {
  double triangles = 0; ///< means over the frames
  double drawCalls = 0;
  double parts = 0;
  double visited = 0;
  double changes = 0; ///< splits and merges of a mesh that is kept
  double uploadBytes = 0;
  double dial = 0;             ///< NaN: the method has none
  TeSpread selectMs;           ///< CPU time; the least of three runs a frame
  double boundPixels = 0;      ///< largest of all frames
  std::int64_t overshoots = 0; ///< frames whose measured error exceeds their bound
  std::int64_t cracks = 0;     ///< TeMeshGaps
  TeMeasuredErrors errors;
};

/// What frames of one method took to draw, by the wall clock.
struct TeFrameFigures {
  TeSpread ms;    ///< choosing, sending and drawing
  TeSpread rawMs; ///< drawing the same triangles by TeRawMesh
  TeSpread ratio; ///< of both, frame by frame: what disturbs one mostly disturbs the other
};

/// Which frames of a flight are measured: 0, stride, 2·stride …, `count` of them. Each is reached from the
/// frame before it, so that methods that keep a mesh do what they do on a smooth flight.
struct TeMeasuredFrames {
  int count = 1;
  int stride = 1;
};

/// Flies over a terrain; jumps are measured from each frame to the one after it. `progress` is told how many
/// frames are done.
TeLodFigures teMeasureLod(TeLodCandidate& candidate, const TeLodAccuracy& accuracy,
                          const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                          const TeMeasuredFrames& frames, const std::function<void(int)>& progress);

/// Draws the same frames on a stage. Error: one of OpenGL.
TeResult<TeFrameFigures> teMeasureFrames(TeLodCandidate& candidate, const TeLodAccuracy& accuracy,
                                         const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                                         const TeMeasuredFrames& frames, TeFlightStage& stage);
