#pragma once

#include <cstdint>
#include <cstring>

/// A number that is not negative in 16 bits, of 9 significant ones; rounded up, so that a bound stays one:
/// by 0.4 % at most.
inline std::uint16_t tePackUp(double number) {
  float rounded = float(number);
  std::uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof(bits));
  std::uint32_t packed = bits >> 15;
  if ((bits & 0x7FFF) != 0 || double(rounded) < number)
    packed++;
  return std::uint16_t(packed < 0xFF00 ? packed : 0xFF00); // infinity
}

inline float teUnpack(std::uint16_t packed) {
  const std::uint32_t bits = std::uint32_t(packed) << 15;
  float number;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

/// Sides are east, north, west, south; side s goes from corner s - 1 to corner s (modulo 4). Corners and
/// quadrants are NE, NW, SW, SE; quadrant k is at sides k and k + 1.
struct TeQuadtreeSides {
  static constexpr int kEast = 0, kNorth = 1, kWest = 2, kSouth = 3;
  static constexpr int kX[4] = {1, 0, -1, 0}; ///< toward side s
  static constexpr int kY[4] = {0, 1, 0, -1};
  static constexpr int opposite(int side) { return (side + 2) & 3; }
  static constexpr int next(int number) { return (number + 1) & 3; }
  static constexpr int previous(int number) { return (number + 3) & 3; }
  static constexpr bool touches(int quadrant, int side) { return side == quadrant || side == next(quadrant); }
  /// The quadrant on the other side of a line through `side`.
  static constexpr int mirrored(int quadrant, int side) {
    return side % 2 == 0 ? quadrant ^ 1 : quadrant ^ 3;
  }
  static constexpr bool isEast(int quadrant) { return quadrant == 0 || quadrant == 3; }
  static constexpr bool isNorth(int quadrant) { return quadrant < 2; }
};

/// A square of the data tree: the heights of its centre and of the middles of its edges; those of its corners
/// belong to larger squares. Its four children, if any, lie one after another.
struct TeQuadtreeSquare {
  enum Flag : std::uint32_t {
    kHasEast = 1,  ///< the square on the other side of an edge exists, or it is the rim: the middle of that
    kHasNorth = 2, ///< edge is a vertex of the surface
    kHasWest = 4,
    kHasSouth = 8,
    kMade = 16,   ///< all heights were derived, so that it can be made again
    kStatic = 32, ///< must not be dropped
    kDirty = 64   ///< errors have to be computed again here, or further down
  };
  static constexpr std::uint32_t kMaxBlock = (1u << 25) - 1;

  float edge[4] = {}; ///< middles of the sides
  float centre = 0;
  /// Largest deviations over all vertices of the surface, of the two triangles that the vertex bisects.
  std::uint16_t centreError = 0;
  std::uint16_t eastError = 0;
  std::uint16_t southError = 0;
  std::uint16_t largestError = 0; ///< the document's: largest vertex error inside, edges included
  std::uint16_t below = 0;        ///< the lowest vertex is no further below the centre
  std::uint16_t above = 0;        ///< the highest above it
  std::uint32_t link = 0;         ///< number of the block of children · 128 + flags

  bool has(std::uint32_t flag) const { return (link & flag) != 0; }
  void set(std::uint32_t flag, bool on) { link = on ? link | flag : link & ~flag; }
  bool hasSide(int side) const { return (link >> side & 1) != 0; }
  std::uint32_t block() const { return link >> 7; } ///< 0: no children
  void setBlock(std::uint32_t block) { link = (link & 127) | block << 7; }

  double low() const { return double(centre) - double(teUnpack(below)); }
  double high() const { return double(centre) + double(teUnpack(above)); }
};

static_assert(sizeof(TeQuadtreeSquare) <= 36, "as much as the document's");
