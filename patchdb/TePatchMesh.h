#pragma once

#include "patchdb/TePatchKey.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// What a mesh is part of: the surface is tiled by patch insides, seams between two patches and corner
/// squares between four.
enum class TeSurfacePart { Patch, Seam, Corner };

/// A piece of the drawn surface as plain arrays: what nodes, collision and exporters are built from.
///
/// Vertex v lies at origin + positions[v] (metres; x east, y north, z up); origin.z is 0, so that local z is
/// the height's own float. Cells are split along their SW-NE diagonal, triangles counter-clockwise seen from
/// above. A cell with a missing corner is left out; vertices that no triangle uses have height 0 and the
/// normal (0, 0, 1), so no array ever holds a NaN.
struct TePatchMesh {
  TeSurfacePart part = TeSurfacePart::Patch;
  TePatchKey key;                    ///< the patch, or the south-west one of those that meet
  TeDirection direction = TeDirection::East; ///< of a seam or corner, seen from `key`
  glm::dvec3 origin{0};
  int columns = 0; ///< vertices are a grid: index = row * columns + column
  int rows = 0;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals; ///< unit
  std::vector<std::int32_t> strips; ///< triangle strips, each ended by -1

  std::size_t bytes() const {
    return (positions.size() + normals.size()) * sizeof(glm::vec3) + strips.size() * sizeof(std::int32_t);
  }
};
