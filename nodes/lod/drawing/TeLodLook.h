#pragma once

#include "nodes/lod/drawing/TeLodSubmission.h"
#include "nodes/seamless/TeSeamlessSlopeColours.h"

#include <optional>

/// How the triangles of a LOD method are drawn.
struct TeLodLook {
  TeLodSubmission submission = TeLodSubmission::VboStatic;
  bool wireframe = false;
  std::optional<TeSeamlessSlopeColours> colours; ///< none: the material's
};
