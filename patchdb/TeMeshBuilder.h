#pragma once

#include "generators/base/TeAllowance.h"
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

/// Makes positions, normals and strips of a mesh from a block of heights, some rows at a time. Any slicing
/// gives the same bits. The block's heights must stay as they are until it is done. All memory is taken by
/// the constructor, which may throw std::bad_alloc.
class TeMeshBuilder {
public:
  static constexpr int kVerticesPerUnit = 4096;

  /// `mesh` brings key, part and direction. Its origin is the middle of the block. A block of less than 2×2
  /// samples gives an empty mesh.
  TeMeshBuilder(const TeLattice& lattice, const TeMeshBlock& block, TePatchMesh mesh);

  /// Builds rows until the allowance is spent, at least one unit; true when done.
  bool step(TeAllowance& allowance);
  /// Builds all that is left and moves the mesh out.
  TePatchMesh finish();
  /// Moves the mesh out, once done.
  TePatchMesh take() { return std::move(m_mesh); }

private:
  double coordinate(std::int64_t sample) const;
  void addRows(int from, int to);
  void addStrip(int y);
  void addStripWithHoles(int y);

  TeLattice m_lattice;
  TeMeshBlock m_block;
  TePatchMesh m_mesh;
  double m_scale;
  std::vector<float> m_localX;
  int m_row = 0;
};
