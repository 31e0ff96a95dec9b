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
/// Vertices are a grid, index = row * columns + column, row 0 in the south. Vertex v lies at
/// origin + positions[v] (metres; x east, y north, z up); origin.z is 0, so that local z is the height's own
/// float. Where two meshes share a sample, origin + position is the same double on both (see
/// teMeshCoordinate()). Cells are split along their SW-NE diagonal, triangles counter-clockwise seen from
/// above. A cell with a missing corner is left out; the vertex of a missing sample has height 0 and the
/// normal (0, 0, 1), so that no array ever holds a NaN.
struct TePatchMesh {
  TeSurfacePart part = TeSurfacePart::Patch;
  TePatchKey key;                            ///< the patch, or the south-west one of those that meet
  TeDirection direction = TeDirection::East; ///< of a seam (East, North) or corner (NorthEast) seen from key
  glm::dvec3 origin{0};
  int columns = 0; ///< 0, and all arrays empty, where there are no cells (patch inside and seams at W = 5)
  int rows = 0;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   ///< unit, exact at every vertex
  std::vector<std::int32_t> strips; ///< triangle strips along rows, each ended by -1

  std::size_t bytes() const {
    return (positions.size() + normals.size()) * sizeof(glm::vec3) + strips.size() * sizeof(std::int32_t);
  }
};

/// The world coordinate at which meshes have a sample of a level: TeLattice::position() rounded to a multiple
/// of the largest power of two that is at most 2^-23 of a patch's side. Differences of up to one side are
/// then exact in float, so that meshes with different origins agree on shared samples to the bit. Spacings
/// that are such multiples themselves (1, 30, 0.5 …) are not changed; others move by less than a float's
/// rounding within the patch.
double teMeshCoordinate(const TeLattice& lattice, int level, double position);
/// Coordinates are multiples of the inverse of this power of two.
double teMeshScale(const TeLattice& lattice, int level);
