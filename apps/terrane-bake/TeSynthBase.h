#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>
#include <string>
#include <vector>

/// The large forms of a synthetic terrain: a square of heights in steps of 0.1 m, rows from the north. The
/// sea is at the lowest of them.
struct TeSynthBase {
  static constexpr int kMostSide = 2049; ///< they are held in memory
  static constexpr int kNoiseSide = 1025;
  static constexpr double kHeightUnit = 0.1; ///< metres
  static constexpr double kExtent = 163840;  ///< metres a side

  int side = 0;
  float sea = 0;
  std::vector<float> heights;

  float at(int column, int row) const { return heights[std::size_t(row) * side + std::size_t(column)]; }

  /// Of an elevation file, its stored heights as they are. Error: unreadable, no square of 4 to kMostSide a
  /// side, heights missing or beyond 0 .. 65535.
  static TeResult<TeSynthBase> fromFile(const std::string& path);
  /// Of gradient noise: a sea with coasts and islands, plains and mountains.
  static TeSynthBase fromNoise(std::uint64_t seed);
};
