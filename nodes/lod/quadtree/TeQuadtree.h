#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/quadtree/TeQuadtreeDetail.h"
#include "nodes/lod/quadtree/TeQuadtreePlace.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

/// The data tree of the adaptive quadtree (docs/adaptive-quadtree.md): heights live in it, dense where there
/// is data and sparse elsewhere, from squares of 2^20 lattice units down to 2.
///
/// The surface: every square is a fan round its centre, over its corners and those middles of its edges where
/// the square on the other side exists, too. Whatever was inserted, two rules keep it without cracks: a
/// square with children has all four neighbours, and so has a square with data. Squares made only for that
/// are *made*, as those of procedural detail are: their vertices lie in the middle of the edge that they
/// split, plus a displacement where there is a TeQuadtreeDetail. So heights do not depend on which squares
/// exist.
///
/// One thread at a time may change it. Memory: 36 bytes a square, and 4 bytes for each lattice unit along a
/// side; a square is three vertices.
class TeQuadtree {
public:
  static constexpr int kMaxSideLog = 20;

  /// A square of a side of 2^sideLog, 1 .. kMaxSideLog, with these heights at its corners (NE, NW, SW, SE).
  /// Error: another side, a height that is not finite.
  static TeResult<TeQuadtree> create(int sideLog, const std::array<float, 4>& corners,
                                     std::shared_ptr<const TeQuadtreeDetail> detail = nullptr);
  /// Dense: all of a map of (2^n + 1)² samples, n from 1 to 14, none of them missing.
  static TeResult<TeQuadtree> create(const TeHeightMap& map);

  /// Puts the samples of a map at (column, row) + (i, j)·2^level. Missing samples and vertices between those
  /// of the map stay as they are, or are derived. Any place and order; parts outside are left out. Corners of
  /// the root stay. Marks squares as static if asked to. Error: an infinite sample, a level out of range, a
  /// column or row that 2^level does not divide, no more room; then the heights are as far as it came.
  /// Cost: a pass over the tree.
  TeStatus insert(const TeHeightMap& map, std::int32_t column, std::int32_t row, int level,
                  bool isStatic = false);

  /// Procedural detail: makes squares of at least 2^leastSideLog (1 or more) around a point of the lattice,
  /// as long as a square's parent is nearer than reach · its side; drops made ones, that are not static and
  /// not in use by the rules, at 1.25 times that. Cost: in proportion to the squares in reach.
  struct DetailChange {
    std::int64_t made = 0; ///< squares
    std::int64_t dropped = 0;
  };
  DetailChange detailAround(double column, double row, double reach, int leastSideLog = 1);
  /// Drops all made squares that are not static and not in use by the rules.
  DetailChange dropDetail();
  /// Of all squares that meet the rectangle of the lattice and are there now.
  void setStatic(std::int32_t column, std::int32_t row, std::int32_t width, std::int32_t height,
                 bool isStatic);

  int sideLog() const { return m_sideLog; }
  std::int32_t side() const { return std::int32_t(1) << m_sideLog; }
  TeQuadtreePlace root() const;
  const TeQuadtreeSquare& square(std::uint32_t number) const { return m_squares[number]; }
  std::uint32_t child(std::uint32_t number, int k) const {
    return TeQuadtreePlace::childOf(m_squares, number, k);
  }
  /// Fetches the records of children into the cache, to look at soon.
  void prefetchChildren(std::uint32_t number) const {
    const std::uint32_t first = child(number, 0);
    if (first == 0)
      return;
    const char* bytes = reinterpret_cast<const char*>(&m_squares[first]);
    for (std::size_t line = 0; line < 4 * sizeof(TeQuadtreeSquare); line += 64)
      __builtin_prefetch(bytes + line);
  }
  /// Deviation of the triangle that the middle of an edge of the rim bisects; west or north.
  float rimError(int side, std::int32_t along) const {
    return teUnpack(m_rim[side == TeQuadtreeSides::kWest][std::size_t(along)]);
  }
  /// The place of a square; empty if it does not exist.
  std::optional<TeQuadtreePlace> find(int sideLog, std::int32_t x, std::int32_t y) const;
  /// Of a vertex of the surface; empty elsewhere.
  std::optional<float> height(std::int32_t column, std::int32_t row) const;
  const std::vector<TeQuadtreeSquare>& squares() const { return m_squares; }

  std::int64_t squareCount() const {
    return std::int64_t(m_squares.size()) - 4 * std::int64_t(m_free.size());
  }
  std::size_t bytes() const;
  /// Grows whenever heights that exist may have changed.
  std::uint64_t heightsVersion() const { return m_heightsVersion; }

private:
  TeQuadtree(int sideLog, const std::array<float, 4>& corners,
             std::shared_ptr<const TeQuadtreeDetail> detail);

  struct Insertion; ///< what insert() works with
  struct Errors;    ///< computes errors again
  /// A square whose four children were made.
  struct MadeBlock {
    std::uint32_t parent;
    std::int32_t x, y;
  };
  struct Viewer {
    double column, row, reach;
    int leastSideLog;
    double distance(std::int32_t x, std::int32_t y, std::int32_t side) const;
  };

  bool isRim(const TeQuadtreePlace& place, int side) const;
  float derived(float a, float b, std::int32_t column, std::int32_t row, int sideLog) const;
  float derivedEdge(const TeQuadtreePlace& place, int side) const;
  float derivedCentre(const TeQuadtreePlace& place, int quadrant) const;
  void deriveAgain(const TeQuadtreePlace& place, int quadrant);
  bool makeNeighbours(TeQuadtreePlace& place);
  bool makeChildren(TeQuadtreePlace& place);
  void makeChild(const TeQuadtreePlace& child, int quadrant);
  std::uint32_t makeSquare(int sideLog, std::int32_t x, std::int32_t y);
  bool insertLevel(TeQuadtreePlace place, int sideLog, const Insertion& insertion);
  bool insertHeights(TeQuadtreePlace& place, const Insertion& insertion);
  void touch(int sideLog, std::int32_t x, std::int32_t y);
  void touchAround(const TeQuadtreePlace& place);
  void detailIn(TeQuadtreePlace place, const Viewer& viewer);
  bool mayDrop(const TeQuadtreePlace& place) const;
  void dropChildren(const TeQuadtreePlace& place);
  std::int64_t dropMade(const Viewer* viewer);
  void markStatic(const TeQuadtreePlace& place, const TeMapRect& rect, bool isStatic);
  void forgetGiven();
  void refreshErrors();

  int m_sideLog;
  std::array<float, 4> m_corners;
  std::shared_ptr<const TeQuadtreeDetail> m_detail;
  std::vector<TeQuadtreeSquare> m_squares;                    ///< 0: the root; block b: 4·b - 3 .. 4·b
  std::vector<std::uint32_t> m_free;                          ///< blocks
  std::array<std::vector<MadeBlock>, kMaxSideLog + 1> m_made; ///< by the parent's sideLog
  std::vector<std::uint16_t> m_rim[2]; ///< errors of middles of the rim's edges: north by column, west by row
  std::uint64_t m_heightsVersion = 0;
  bool m_refreshesAll = true; ///< not what is dirty only
};
