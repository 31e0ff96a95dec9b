#pragma once

#include "generators/base/TeResult.h"

#include <cstdint>

/// Sides of a patch, clockwise from the north, in the order of the document's top, right, bottom, left.
enum TeSide { TeNorth = 0, TeEast = 1, TeSouth = 2, TeWest = 3 };

/// One side in the grid of patches of a tree level with n × n patches. Horizontal sides lie south of patch
/// (x, y), with 0 <= x < n and 0 <= y <= n; vertical ones west of patch (x, y), with 0 <= x <= n, 0 <= y < n.
struct TeSideKey {
  int level = 0;
  bool horizontal = true;
  std::int32_t x = 0;
  std::int32_t y = 0;
};

/// Sizes of Seamless Patches (Livny, Kogan and El-Sana 2007) over a square of `resolution` cells, that is
/// resolution + 1 samples, a side.
///
/// A patch is drawn with minResolution, 2·minResolution, … maxResolution triangles along a side: resolution
/// index 0 .. levels - 1. It has branching() × branching() children, so that a parent at its highest and its
/// children at their lowest resolution have the same cells. Tree level 0 is one patch over everything; level
/// k has patchesPerSide(k)² patches of cells(k) samples' distance a side. At the deepest level the highest
/// resolutions may be finer than the samples; they are not used (topIndex()).
///
/// In arrays a patch has the index of the document: 0 for the root, children i·N + 1 .. i·N + N of patch i
/// with N = branching()², from the south-west, row by row.
class TeSeamlessLayout {
public:
  static constexpr int kMaxLevels = 9;            ///< resolutions 2 .. 512
  static constexpr int kMaxPatchResolution = 512; ///< a tile then has as many vertices as 16 bits number
  static constexpr int kMaxResolution = 1 << 22;

  /// Error: a number that is no power of two or out of range (resolution minResolution .. kMaxResolution,
  /// minResolution from 2, levels 2 .. kMaxLevels, highest resolution of a patch up to kMaxPatchResolution);
  /// the message names it.
  static TeResult<TeSeamlessLayout> create(int resolution, int minResolution, int levels);

  int resolution() const { return m_resolution; }
  int minResolution() const { return 1 << m_minLog; }
  int maxResolution() const { return 1 << (m_minLog + m_levels - 1); }
  int levels() const { return m_levels; }
  int branching() const { return 1 << (m_levels - 1); }
  int depth() const { return m_depth; } ///< number of tree levels
  int resolutionLog() const { return m_resolutionLog; }
  int maxResolutionLog() const { return m_minLog + m_levels - 1; }

  std::int32_t patchesPerSide(int level) const { return std::int32_t(1) << (level * (m_levels - 1)); }
  int cells(int level) const { return m_resolution >> (level * (m_levels - 1)); }
  int cellsLog(int level) const { return m_resolutionLog - level * (m_levels - 1); }
  /// Triangles along a side at a resolution index.
  int resolutionOf(int index) const { return 1 << (m_minLog + index); }
  /// Highest resolution index at a tree level: levels() - 1, less at the deepest level where samples end.
  int topIndex(int level) const;
  /// log2 of the distance, in samples, between the vertices of a patch of that tree level.
  int spacingLog(int level, int index) const { return cellsLog(level) - m_minLog - index; }

  std::int64_t patchCount() const;          ///< in all levels
  std::int64_t firstPatch(int level) const; ///< array index of the first patch of a level
  std::int64_t parent(std::int64_t patch) const { return (patch - 1) >> (2 * (m_levels - 1)); }
  std::int64_t firstChild(std::int64_t patch) const { return (patch << (2 * (m_levels - 1))) + 1; }

  std::int64_t sideCount(int level) const;
  std::int64_t sideIndex(const TeSideKey& side) const; ///< 0 .. sideCount(level) - 1
  static TeSideKey sideOf(int level, std::int32_t x, std::int32_t y, TeSide side);

  friend bool operator==(const TeSeamlessLayout& a, const TeSeamlessLayout& b);
  friend bool operator!=(const TeSeamlessLayout& a, const TeSeamlessLayout& b) { return !(a == b); }

private:
  TeSeamlessLayout() = default;

  int m_resolution = 0;
  int m_resolutionLog = 0;
  int m_minLog = 0;
  int m_levels = 0;
  int m_depth = 0;
};
