#pragma once

#include "nodes/lod/TeLodMesh.h"
#include "nodes/seamless/TeSeamlessParts.h"
#include "nodes/seamless/TeSeamlessSelection.h"

#include <cstdint>
#include <vector>

/// Heights by sample of the finest level: a map in memory, or what a clipmap holds.
class TeSeamlessHeights {
public:
  virtual ~TeSeamlessHeights() = default;
  /// Height of a sample that the selection uses, in the unit of the samples. `heightLevel`: of the pyramid,
  /// as in TeSeamlessInstance.
  virtual float height(std::int32_t column, std::int32_t row, int heightLevel) const = 0;
};

/// The triangles of a selection as they are drawn, in the memory of the CPU.
struct TeSeamlessMesh {
  using Vertex = TeLodVertex; ///< its height morphed
  struct Triangle {
    Vertex a, b, c; ///< counter-clockwise from above
    bool strip = false;
  };

  /// Appends the triangles of one patch.
  static void appendPatch(const TeSeamlessPatch& patch, const TeSeamlessLayout& layout,
                          const TeSeamlessParts& parts, const TeSeamlessHeights& heights,
                          std::vector<Triangle>& triangles);
};
