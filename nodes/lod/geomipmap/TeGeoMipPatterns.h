#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// Sides of a patch, counter-clockwise.
enum class TeGeoMipSide { South, East, North, West };

/// Levels at which the four sides of a patch are drawn: that of the patch, or that of a coarser neighbour.
using TeGeoMipSides = std::array<int, 4>;

/// How patches of one size are triangulated, at all levels and beside all neighbours (de Boer, "Fast Terrain
/// Rendering Using Geometrical MipMapping", 2000): shared by all patches.
///
/// Level l of a patch of P cells a side has n = P >> l cells a side, from P to 1, split along SW-NE. From n =
/// 2 on, the outermost ring of cells is four strips, one a side, that meet on the diagonals of the corner
/// cells. A strip beside a coarser neighbour has vertices on the border only where the neighbour has, and
/// fans from these and from the inner row between them; it depends on nothing but the levels of both. Where
/// two strips that are not stitched meet, their corner cell is split along SW-NE like all others, so that a
/// patch beside neighbours of its own level is the regular grid.
///
/// Immutable; thread-safe.
class TeGeoMipPatterns {
public:
  static constexpr int kMaxPatchCells = 128;

  /// A power of two from 2 to kMaxPatchCells.
  explicit TeGeoMipPatterns(int patchCells);

  int patchCells() const { return m_patchCells; }
  int levels() const { return m_levels; }
  int cells(int level) const { return m_patchCells >> level; }

  struct Point {
    int x = 0; ///< in samples from the patch's south-west corner
    int y = 0;
  };
  using Triangle = std::array<Point, 3>; ///< counter-clockwise

  /// All cells of a level, split along SW-NE.
  std::vector<Triangle> regular(int level) const;
  /// The strip at a side of a patch of `level` beside a neighbour of `border`, a coarser level.
  std::vector<Triangle> stitched(int level, TeGeoMipSide side, int border) const;
  /// Of a strip that is not stitched: its half of the corner cell at its first (false) or last end,
  /// counter-clockwise, where the other half belongs to a stitched one.
  Triangle half(int level, TeGeoMipSide side, bool last) const;

  std::int64_t triangles(int level, const TeGeoMipSides& sides) const;
  /// Three numbers a triangle: `first` + y·(n + 1) + x on the lattice of the level, which has (n + 1)²
  /// vertices.
  void append(int level, const TeGeoMipSides& sides, std::uint32_t first,
              std::vector<std::uint32_t>& indices) const;

private:
  using Indices = std::vector<std::uint16_t>;
  void add(const Triangle& triangle, int level, Indices& indices) const;
  void addCell(int column, int row, int level, Indices& indices) const;
  Triangle turned(const Triangle& south, TeGeoMipSide side) const;

  struct Level {
    Indices inner;                                ///< without the outermost ring
    std::array<std::vector<Indices>, 4> strips;   ///< [side][border - level]; the first without corners
    std::array<Indices, 4> corners;               ///< [side]: the cell at the side's first end, regular
    std::array<std::array<Indices, 2>, 4> halves; ///< [side][last]
  };
  template <class Add> void forPieces(int level, const TeGeoMipSides& sides, Add add) const;

  int m_patchCells;
  int m_levels = 1;
  std::vector<Level> m_pieces;
};
