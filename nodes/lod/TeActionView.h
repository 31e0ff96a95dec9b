#pragma once

#include "nodes/lod/TeLodView.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <optional>

class SbLine;
class SoAction;
class SoCamera;
class SoState;

/// What a terrain node asks of the action that has come to it.
class TeActionView {
public:
  /// The view of the state's camera, or of `lodCamera` if there is one (TeCameraView). Without a camera:
  /// `otherwise`. Empty: nothing can be seen.
  static std::optional<TeLodView> view(SoState* state, const SoCamera* lodCamera, const TeLodView& otherwise);
  /// Of a square terrain from as high above its middle as it is wide; all of it, on 1024 pixels.
  static TeLodView fromAbove(const glm::dvec3& corner, double side, double top);

  /// Of the place in the scene that an action has come to: the same node may stand in several.
  static std::uint64_t placeOf(SoAction* action);
  /// By which SoComplexity makes everything more accurate: 16^(value - 0.5); 1 by default.
  static double accuracyFactor(SoState* state);

  /// From the shape's coordinates to those of the eye, in glm's order (column vectors), and from there to
  /// clip coordinates.
  static glm::dmat4 eyeFromModel(SoState* state);
  static glm::dmat4 projection(SoState* state);

  /// Leaves of what a view sees only what lies along a line, from its beginning on; as sharply as before.
  /// `size`: of the terrain.
  static void seeOnly(const SbLine& line, double size, TeLodView& view);
};
