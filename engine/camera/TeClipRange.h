#pragma once

/// Distances of a camera's near and far plane.
struct TeClipRange {
  static constexpr double kFarPerNear = 20000;
  static constexpr double kNearest = 0.05; ///< metres

  double nearDistance = 0.5;
  double farDistance = 10000;

  /// What an eye needs, in metres. `reach`: horizontal distance of the farthest terrain that may be drawn;
  /// `heightAboveGround` of the eye (negative and NaN count as 0); `objectDistance` to the object that it
  /// looks at, 0 if none.
  ///
  /// It does not depend on which terrain is there. Both planes move in factors of 2, so that they stay while
  /// an eye moves little. Far encloses slopes of 45° up or down all the way. Near is a tenth of the height or
  /// less, at least far / kFarPerNear so that 24 bits of depth tell surfaces apart, yet never more than half
  /// the distance to the object, and at least kNearest.
  static TeClipRange of(double reach, double heightAboveGround, double objectDistance);

  friend bool operator==(const TeClipRange& a, const TeClipRange& b) {
    return a.nearDistance == b.nearDistance && a.farDistance == b.farDistance;
  }
};
