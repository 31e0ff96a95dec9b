#pragma once

#include "nodes/lod/chunked/TeChunkTree.h"

#include <array>
#include <cstdint>

/// A chunk as it is drawn: all that its triangles depend on.
struct TeChunkPart {
  static constexpr int kWhole = 256; ///< weight of vertices at their own heights

  /// What lies beyond a side, as far as a skirt must know.
  enum Beyond : int {
    Nothing, ///< no skirt: the terrain ends, or the same vertices
    Hidden,  ///< nothing that is in view
    Finer,
    Equal,   ///< of the same level, but maybe morphed otherwise
    Coarser, ///< by one level; more: as many above
  };

  int level = 0;
  int x = 0; ///< chunk of the level
  int y = 0;
  int weight = kWhole;   ///< 0: on the parent's surface
  bool morphing = false; ///< chunks beside it may be morphed
  std::array<int, TeChunkTree::kSides> beyond{};

  std::uint64_t key() const {
    std::uint64_t key = std::uint64_t(level) << 26 | std::uint64_t(y) << 13 | std::uint64_t(x);
    key = key << 9 | std::uint64_t(weight);
    key = key << 1 | std::uint64_t(morphing);
    for (const int side : beyond)
      key = key << 5 | std::uint64_t(side);
    return key;
  }
  static TeChunkPart of(std::uint64_t key) {
    const auto take = [&key](int bits) {
      const int value = int(key & ((std::uint64_t(1) << bits) - 1));
      key >>= bits;
      return value;
    };
    TeChunkPart part;
    for (std::size_t side = part.beyond.size(); side-- > 0;)
      part.beyond[side] = take(5);
    part.morphing = take(1) != 0;
    part.weight = take(9);
    part.x = take(13);
    part.y = take(13);
    part.level = take(4);
    return part;
  }
};
