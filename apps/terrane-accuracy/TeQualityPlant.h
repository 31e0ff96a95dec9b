#pragma once

#include "apps/terrane-accuracy/TeQualityTrace.h"

/// A program that exists on paper: at p pixels a frame costs load · (fixed + (1 - fixed) · p^-exponent)
/// goals, give or take its noise. What TeQuality makes of it, without a machine that other programs disturb.
struct TeQualityPlant {
  double rate = 60; ///< goals a second
  double exponent = 1;
  double fixed = 0.15;
  double noise = 0.1; ///< ± part of each frame
  int delay = 1;      ///< frames from a choice to its effect

  /// The load is 1 in the beginning, then as the steps say. Repeats to the bit.
  TeQualityTrace run(const std::vector<TeQualityTrace::Step>& steps) const;
};
