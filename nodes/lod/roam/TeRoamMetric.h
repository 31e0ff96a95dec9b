#pragma once

/// What makes a triangle important.
enum class TeRoamMetric {
  /// Exact error · focal length / distance to the triangle's box, in pixels: a bound of what is seen.
  ScreenError,
  /// The document's formula 6.1: variance / distance to the triangle's centroid. No bound: the middles of
  /// edges say
  /// little of other samples, and a corner may be near where the centroid is far.
  Variance,
  /// The document's formula 6.2: 2 · width of the terrain · variance / distance. The same order in another
  /// unit.
  ScaledVariance
};
