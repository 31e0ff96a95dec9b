#pragma once

#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <array>
#include <cstddef>
#include <cstdint>

/// A patch as it is drawn: all that its triangles depend on.
struct TeGeoMipPart {
  static constexpr int kWhole = 16; ///< weight of vertices at their own heights

  int x = 0; ///< patch
  int y = 0;
  int level = 0;
  TeGeoMipSides sides{};
  int weight = kWhole; ///< 0: on the surface of the next coarser level
  std::array<int, 4> borderWeights{kWhole, kWhole, kWhole, kWhole};

  /// Of up to 4096 patches a side.
  std::uint64_t key(int patches) const {
    std::uint64_t key = std::uint64_t(y) * std::uint64_t(patches) + std::uint64_t(x);
    key = key << kLevelBits | std::uint64_t(level);
    for (const int side : sides)
      key = key << kLevelBits | std::uint64_t(side);
    key = key << kWeightBits | std::uint64_t(weight);
    for (const int border : borderWeights)
      key = key << kWeightBits | std::uint64_t(border);
    return key;
  }
  static TeGeoMipPart of(std::uint64_t key, int patches) {
    const auto take = [&key](int bits) {
      const int value = int(key & ((std::uint64_t(1) << bits) - 1));
      key >>= bits;
      return value;
    };
    TeGeoMipPart part;
    for (std::size_t side = 4; side-- > 0;)
      part.borderWeights[side] = take(kWeightBits);
    part.weight = take(kWeightBits);
    for (std::size_t side = 4; side-- > 0;)
      part.sides[side] = take(kLevelBits);
    part.level = take(kLevelBits);
    part.x = int(key % std::uint64_t(patches));
    part.y = int(key / std::uint64_t(patches));
    return part;
  }

private:
  static constexpr int kLevelBits = 3;
  static constexpr int kWeightBits = 5;
};
