#pragma once

#include "nodes/lod/TeLodBox.h"
#include "nodes/lod/TeLodField.h"

#include <array>
#include <cstdint>
#include <vector>

/// The quadtree of chunks of Chunked LOD (Ulrich, "Rendering Massive Terrains using Chunked Level of Detail
/// Control", 2002), with all that is known of each in advance.
///
/// A chunk of level 0 is a square of `leafCells` cells a side with all of its samples; one of level L has
/// 2^L times the side, and a mesh that deviates by levelError(L) at most, which halves from level to level.
/// The root is the whole terrain.
///
/// The meshes are right triangles that were bisected wherever their exact error is above that (TeRtinErrors).
/// They are kept as one byte a sample: the coarsest level at which it is a vertex. Errors of vertices are
/// nested, so the mesh of a chunk refines that of its parent, triangle by triangle, and chunks of the same
/// level have the same vertices on their common border.
///
/// Immutable; thread-safe. Memory: a byte a sample and 48 a chunk.
class TeChunkTree {
public:
  static constexpr int kSides = 4; ///< south, east, north, west

  /// `leafCells`: a power of two, at most the terrain's side. `firstError`: of level 1, in the unit of the
  /// samples; negative: what a quarter of the samples that have an error exceed.
  TeChunkTree(TeLodFieldPtr field, int leafCells, float firstError);

  const TeLodField& field() const { return *m_field; }
  int leafCells() const { return m_leafCells; }
  int levels() const { return m_levels; }
  int cells(int level) const { return m_leafCells << level; }         ///< of a chunk, a side
  int chunks(int level) const { return 1 << (m_levels - 1 - level); } ///< a side
  float levelError(int level) const { return m_levelErrors[std::size_t(level)]; }
  /// The largest error of chunks of a level and of all finer ones.
  float largestError(int level) const { return m_largestErrors[std::size_t(level)]; }

  struct Chunk {
    float error = 0; ///< largest deviation of its mesh from the samples, exact and rounded up
    float low = 0;   ///< of the samples
    float high = 0;
    std::int32_t triangles = 0; ///< without skirts
    /// Largest deviations of its borders, and of how many edges they are.
    std::array<float, kSides> borderErrors{};
    std::array<std::int32_t, kSides> borderEdges{};
  };
  std::size_t number(int level, int x, int y) const {
    return m_first[std::size_t(level)] + std::size_t(y) * std::size_t(chunks(level)) + std::size_t(x);
  }
  const Chunk& chunk(int level, int x, int y) const { return m_chunks[number(level, x, y)]; }
  std::size_t chunkCount() const { return m_chunks.size(); }
  TeLodBox box(int level, int x, int y) const;

  /// Whether a sample is a vertex of meshes of a level, from 1; corners of chunks are, in any case.
  bool isVertex(int level, int column, int row) const {
    return m_vertexLevels[std::size_t(row) * m_width + std::size_t(column)] >= level;
  }

  /// The two triangles that the mesh of a chunk begins with, counter-clockwise, the hypotenuse first; all
  /// others follow by bisection.
  struct Square {
    int column = 0; ///< of its south-west corner
    int row = 0;
    int cells = 0;
    bool rising = true; ///< the diagonal runs from south-west to north-east
  };
  Square square(int level, int x, int y) const;

  std::size_t bytes() const { return m_vertexLevels.capacity() + m_chunks.capacity() * sizeof(Chunk); }

private:
  void markVertices(float firstError);
  void measure(int level, int x, int y);

  TeLodFieldPtr m_field;
  int m_leafCells;
  int m_levels = 1;
  std::size_t m_width; ///< samples a side
  std::vector<float> m_levelErrors;
  std::vector<float> m_largestErrors;
  std::vector<std::size_t> m_first; ///< chunk of each level
  std::vector<Chunk> m_chunks;
  std::vector<std::uint8_t> m_vertexLevels;
};
