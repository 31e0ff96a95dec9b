#pragma once

#include "apps/terrane-accuracy/TeFlightStage.h"
#include "apps/terrane-accuracy/TeLodCandidate.h"
#include "apps/terrane-accuracy/TeMeasuredTerrain.h"
#include "nodes/lod/SoTeLodTerrain.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <memory>

/// Draws frames of a method on a stage, to see how long all of it takes: choosing, sending, drawing. Seamless
/// Patches by their own node, with heights on the GPU; others by SoTeLodTerrain, with buffers that stay.
class TeLodDrawing {
public:
  /// The stage must outlive it. Error: the node does not take the terrain.
  static TeResult<std::unique_ptr<TeLodDrawing>>
  create(const TeLodCandidate& candidate, const TeMeasuredTerrain& terrain, TeFlightStage& stage);

  /// Milliseconds of a frame, by the wall clock. Error: one of OpenGL.
  TeResult<double> draw(const TeLodAccuracy& accuracy, const TePerspectiveView& view);

private:
  explicit TeLodDrawing(TeFlightStage& stage) : m_stage(stage) {}
  TeStatus prepareSeamless(const TeLodCandidate& candidate, const TeMeasuredTerrain& terrain);
  void prepareOther(const TeLodCandidate& candidate, const TeMeasuredTerrain& terrain);

  TeFlightStage& m_stage;
  TeNodePtr<SoTeSeamlessPatches> m_seamless; ///< or
  TeNodePtr<SoTeLodTerrain> m_other;
};
