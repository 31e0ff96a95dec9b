#pragma once

#include "nodes/seamless/TeSeamlessTerrain.h"

#include <Inventor/SbBox3f.h>
#include <Inventor/SbVec3f.h>

#include <functional>
#include <vector>

/// A selection's triangles in the coordinates of the node, in the memory of the CPU. Vertices that patches
/// share have the same bits.
class TeSeamlessSurface {
public:
  struct Triangle {
    SbVec3f corners[3]; ///< counter-clockwise from above
    bool strip = false;
    SbVec3f normal() const; ///< of unit length
  };

  /// All must outlive it.
  TeSeamlessSurface(const TeSeamlessTerrain& terrain, const TeSeamlessPlacement& placement,
                    const TeSeamlessHeights& heights)
      : m_terrain(terrain), m_placement(placement), m_heights(heights) {}

  SbVec3f position(const TeSeamlessMesh::Vertex& vertex) const;
  /// Around the whole terrain, and around one patch.
  static SbBox3f box(const TeSeamlessPlacement& placement, const TeSeamlessLayout& layout);
  SbBox3f box(const TeSeamlessPatch& patch) const;
  /// Memory is used again.
  const std::vector<Triangle>& triangles(const TeSeamlessPatch& patch);

private:
  const TeSeamlessTerrain& m_terrain;
  const TeSeamlessPlacement& m_placement;
  const TeSeamlessHeights& m_heights;
  std::vector<TeSeamlessMesh::Triangle> m_samples;
  std::vector<Triangle> m_triangles;
};
