#pragma once

#include "nodes/lod/TePerspectiveView.h"

#include <cstdint>
#include <functional>

/// A flight along a circle around the middle of a square terrain, to measure by: the same for every method
/// and at any time. The eye keeps a height above the samples near below it and looks along the circle's
/// tangent, somewhat down.
///
/// The terrain lies as with TeSeamlessPlacement at corner 0: sample (column, row) at (column, row)·spacing,
/// its height times heightScale.
struct TeFlyover {
  static constexpr int kNearCells = 4; ///< samples that far are near

  int cells = 1; ///< of the terrain, a side
  double spacing = 1;
  double heightScale = 1;
  /// Height of a sample in its unit; columns and rows 0 .. cells.
  std::function<float(std::int32_t, std::int32_t)> sample;

  double radius = 0.3;        ///< of the circle, in sides of the terrain; to 0.5
  double anglePerFrame = 0.5; ///< degrees; counter-clockwise
  double clearance = 150;     ///< metres above the highest sample near the eye
  double pitch = -8;          ///< degrees
  double nearDistance = 10;
  double farDistance = 30000;
  int width = 1024;
  int height = 768;
  double fieldOfView = 60; ///< vertical, degrees

  TePerspectiveView view(int frame) const;
};
