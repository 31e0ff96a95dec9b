#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/drawing/TeLodLook.h"

#include <Inventor/nodes/SoCamera.h>

#include <string>

/// A terrain that a LOD method draws, ready to be seen.
struct TeLodScene {
  std::string method;     ///< one of TeLodMethods
  TeLodFieldPtr field;    ///< null: there is nothing to see
  glm::dvec3 offset{0};   ///< added to the field's coordinates: those of the node
  TeLodAccuracy accuracy; ///< before SoComplexity
  double slice = 0;       ///< seconds of CPU time for a selection; 0: as long as it takes
  TeLodLook look;
  TeNodePtr<SoCamera> lodCamera; ///< null: the one that draws
};
