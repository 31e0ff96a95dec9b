#pragma once

#include "nodes/lod/TeLodField.h"

/// How large fields of a node say that a square of samples is drawn.
struct TeSquareExtent {
  static constexpr double kLargest = 1e9; ///< metres

  int cells = 1;      ///< a side
  double spacing = 1; ///< metres between samples, if the fields do not say
  bool isRaw = false; ///< samples are 16 bit numbers; else metres

  /// Around `middle`, at height 0. `size`: extents in x and y, 0: as `spacing` says; and height of the
  /// largest 16 bit number. Error: unequal extents, one of them out of range, not finite.
  TeResult<TeLodField::Placement> place(const glm::dvec3& size, const glm::dvec3& middle) const;
};
