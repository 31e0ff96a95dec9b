#pragma once

#include "generators/TeHeightSource.h"

/// The largest map, in samples, that evaluate() may make to read its samples from: 4 MB of heights.
inline constexpr double kTeMaxMapInstead = 0x1p20;

/// Evaluates many samples of a map by making the map: for sources whose maps cost less than their samples one
/// by one. The same bits, by the contract of evaluate().
TeStatus teEvaluateFromMap(const TeHeightSource& source, const TeMapRequest& request,
                           const TeMapSample* samples, std::size_t count, float* heights);
