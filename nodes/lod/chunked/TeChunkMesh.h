#pragma once

#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/chunked/TeChunkPart.h"

#include <cstdint>
#include <utility>
#include <vector>

/// Makes the triangles of chunks, and the walls that hang from their borders.
///
/// Surface. Vertices of a part of weight w stand at own·w/256 + parent's·(1 - w/256), where `parent's` is the
/// height of the parent's surface there. So the part deviates by w/256·error + (1 - w/256)·error of the
/// parent, and by rounding.
///
/// Skirts. Two chunks that meet along a line are polylines over it, a and b, with corners on samples. If they
/// deviate from the samples of the line by at most ea and eb, |a - b| <= ea + eb all along. A part's skirt at
/// a side hangs from its border, parallel to it, by ea + eb, where eb allows for every chunk that may lie
/// beyond a side of that kind (Beyond); so where it is the higher one its wall reaches the lower one. Where
/// both deviate by nothing a little is left, for a vertex in the middle of an edge is not drawn exactly on
/// it. Beyond a side there may be a chunk that is not in view, while the border is, for it deviates from the
/// samples: there the wall reaches the samples, which are not in view. Each number is static: a part is a
/// function of its key.
///
/// Cost: about 30 ns a triangle. One thread at a time; keeps its tables.
class TeChunkMesh {
public:
  /// `tree` must outlive it.
  explicit TeChunkMesh(const TeChunkTree& tree);

  /// Largest deviation of a part, in the unit of the samples.
  double error(const TeChunkPart& part) const;
  /// What rounding adds to the error of parts that are morphed.
  double rounding() const { return 0x1p-23 * m_largestHeight; }
  /// How far the skirt at a side hangs down; 0: there is none.
  float skirtDepth(const TeChunkPart& part, int side) const;
  /// With skirts.
  std::int64_t triangles(const TeChunkPart& part) const;
  void append(const TeChunkPart& part, TeLodMesh& mesh);

  std::size_t bytes() const;

private:
  struct Corner {
    std::int32_t column;
    std::int32_t row;
    std::uint32_t index; ///< in the mesh
    double parent;       ///< height of the parent's surface
  };
  struct Heights; ///< makes corners of the parent's surface alone
  struct Vertices;
  struct Output;

  double parentError(const TeChunkPart& part) const;
  double borderError(const TeChunkPart& part, int side) const;
  /// Of the parent's surface at a corner of the part's square.
  double parentAtCorner(const TeChunkPart& part, int column, int row) const;
  float morphed(float own, double parent, int weight) const;
  void appendCells(const TeChunkPart& part, TeLodMesh& mesh);
  void beginTable(std::size_t vertices);
  /// The number kept for something, and whether it is new: it is `next` then.
  std::pair<std::uint32_t, bool> numberOf(std::uint64_t what, std::uint32_t next);

  const TeChunkTree& m_tree;
  double m_largestHeight;  ///< of all samples, absolute
  double m_leastDepth = 0; ///< of skirts
  struct Slot {
    std::uint64_t what;
    std::uint32_t number;
  };
  std::vector<Slot> m_table; ///< open addressing; a power of two
  std::size_t m_mask = 0;
  std::vector<double> m_parents; ///< by sample of a leaf
};
