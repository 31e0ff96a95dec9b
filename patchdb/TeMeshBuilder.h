#pragma once

#include "patchdb/TePatchMesh.h"

/// A block of samples of one level, with a ring of one sample around it for the normals.
struct TeMeshBlock {
  const float* heights = nullptr; ///< the block's first sample; (-1, -1) .. (columns, rows) are readable
  int stride = 0;
  int columns = 0;
  int rows = 0;
  bool missing = false;               ///< there may be missing samples in the block or its ring
  glm::vec<2, std::int64_t> first{0}; ///< global number of the block's first sample
};

/// Fills positions, normals and strips of a mesh whose key, part and direction are set. Its origin is the
/// middle of the block. A block of less than 2×2 samples gives an empty mesh.
void teBuildMesh(const TeLattice& lattice, const TeMeshBlock& block, TePatchMesh& mesh);
