#pragma once

#include "nodes/seamless/TeSeamlessLayout.h"

#include <array>
#include <cstdint>
#include <vector>

/// A vertex of a tile or strip in its patch: (x, y) / maxResolution of the patch's side from the south-west.
struct TePartVertex {
  /// Chains that move together when details have fractions: with the detail of a side (TeSide), or, on the
  /// diagonal after a side (clockwise), with the higher one of that side and the next.
  static constexpr std::uint16_t kDiagonal = 4; ///< plus the side
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t chain = 0;
  std::uint16_t padding = 0;
};

/// Triangles of one part at its resolutions, counter-clockwise from above: index i of `count` from
/// `firstIndex` on stands for vertex firstVertex + indices()[i].
struct TePart {
  std::int32_t firstVertex = 0;
  std::int32_t firstIndex = 0;
  std::int32_t count = 0;
};

/// The four tiles and four strips of a patch of unit size, at all resolutions and in all orientations; made
/// once. Layout of vertices and indices as in the document: vertices of the north, east, south, west tile,
/// then of the north-east, south-east, south-west, north-west strip; indices of tiles from the highest
/// resolution to the lowest, then of strips a-b by falling a, then falling b, where a belongs to the side
/// before the strip (clockwise). 16 bit indices count from each part's first vertex.
///
/// In each quadrant of the patch all cells are split along the diagonal toward its centre, so that every
/// triangle of a resolution is four of the next. Where a strip joins two resolutions its diagonal has the
/// vertices of the finer one, and the coarser half fans.
///
/// After these may come whole patches, the same triangles together: one for each combination of the four
/// sides' resolutions, all with the vertices of one grid.
class TeSeamlessParts {
public:
  /// `wholePatches`: with them, if that many fit (fitsWholePatches()).
  explicit TeSeamlessParts(const TeSeamlessLayout& layout, bool wholePatches = false);

  /// Whether a grid is numbered by 16 bits and all combinations take up to 8 MB.
  static bool fitsWholePatches(const TeSeamlessLayout& layout);

  const std::vector<TePartVertex>& vertices() const { return m_vertices; }
  const std::vector<std::uint16_t>& indices() const { return m_indices; }

  int levels() const { return m_levels; }
  TePart tile(int side, int index) const;
  /// Strip after `side` (clockwise): between side, at resolution index a, and the next, at b.
  TePart strip(int side, int a, int b) const;
  bool hasWholePatches() const { return !m_firstPatchIndex.empty(); }
  /// Whole patch with the sides' resolution indices by TeSide; only if hasWholePatches().
  TePart patch(const std::array<std::uint8_t, 4>& indices) const;

private:
  void addWholePatches(int resolution);
  TePart part(std::int32_t firstVertex, int list) const;

  int m_levels = 0;
  std::int32_t m_tileVertices = 0; ///< of one orientation
  std::int32_t m_stripVertices = 0;
  std::vector<std::int32_t> m_firstIndex; ///< of tiles, then of strips; and one past the last
  std::int32_t m_firstPatchVertex = 0;
  std::vector<std::int32_t> m_firstPatchIndex; ///< by combination; and one past the last
  std::vector<TePartVertex> m_vertices;
  std::vector<std::uint16_t> m_indices;
};
