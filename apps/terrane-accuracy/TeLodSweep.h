#pragma once

#include "apps/terrane-accuracy/TeFlightStage.h"
#include "apps/terrane-accuracy/TeMeasuredErrors.h"
#include "apps/terrane-accuracy/TeMeasuredMethod.h"
#include "apps/terrane-accuracy/TeSpread.h"

/// One method at one accuracy over a flight.
struct TeLodFigures {
  double triangles = 0; ///< means over the frames
  double drawCalls = 0;
  double parts = 0;
  double visited = 0;
  double uploadBytes = 0;
  double dial = 0;
  TeSpread selectMs;           ///< CPU time; the least of three runs a frame
  double boundPixels = 0;      ///< largest of all frames
  std::int64_t overshoots = 0; ///< frames whose measured error exceeds their bound
  std::int64_t cracks = 0;
  TeMeasuredErrors errors;
};

/// What frames of one method took to draw, by the wall clock.
struct TeFrameFigures {
  TeSpread ms;    ///< choosing, sending and drawing
  TeSpread rawMs; ///< drawing the same triangles by TeRawMesh
  TeSpread ratio; ///< of both, frame by frame: what disturbs one mostly disturbs the other
};

/// Flies over a terrain: frames 0, stride, 2·stride …, `frames` of them; jumps are measured from each of them
/// to the frame after it. `progress` is told how many frames are done.
TeLodFigures teMeasureLod(TeMeasuredMethod& method, const TeDial& dial, const TeMeasuredTerrain& terrain,
                          const TeFlyover& flight, int frames, int stride,
                          const std::function<void(int)>& progress);

/// Draws the same frames on a stage. Error: one of OpenGL.
TeResult<TeFrameFigures> teMeasureFrames(TeMeasuredMethod& method, const TeDial& dial,
                                         const TeMeasuredTerrain& terrain, const TeFlyover& flight,
                                         int frames, int stride, TeFlightStage& stage);
