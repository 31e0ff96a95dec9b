#pragma once

#include "nodes/lod/TeLodView.h"

#include <optional>

class SbMatrix;
class SbVec2s;
class SbViewVolume;
class SoCamera;
class SoState;

/// What Coin's cameras see, as a TeLodView in the coordinates of a shape under transforms.
///
/// Where the shape is scaled differently along its axes, or sheared, `focal` is so much larger that
/// TeLodView::pixels() is too large rather than too small in every direction. Pixels that are not square
/// count by their longer density. A view is empty if something about it is not finite, or a transform
/// flattens the shape: nothing can be drawn then.
class TeCameraView {
public:
  static std::optional<TeLodView> create(const SbViewVolume& volume, const SbVec2s& pixels,
                                         const SbMatrix& model);

  /// Whether a camera was traversed. False also for actions that keep no view volume.
  static bool hasCamera(SoState* state);
  /// Of the state's camera and viewport, for a shape under the state's transforms.
  static std::optional<TeLodView> fromState(SoState* state);
  /// Of another camera, wherever in the scene it stands or whether it does, as if it were traversed under no
  /// transform with the state's viewport.
  static std::optional<TeLodView> fromCamera(const SoCamera& camera, SoState* state);
};
