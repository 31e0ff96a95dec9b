#pragma once

#include "generators/TeHeightSource.h"

#include <array>

/// A finished source map: W×W samples, unweighted.
struct TeSourceMap {
  TeMapKey key;
  TeHeightSourcePtr source; ///< what made it
  TeHeightMap heights;
};
using TeSourceMapPtr = std::shared_ptr<const TeSourceMap>;

/// The source maps of a base patch: corner 0 = south-west, 1 = south-east, 2 = north-west, 3 = north-east.
using TePatchMaps = std::array<TeSourceMapPtr, 4>;
