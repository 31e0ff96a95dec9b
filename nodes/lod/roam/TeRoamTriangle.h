#pragma once

#include <cstdint>

/// A triangle of the triangle quadtree over a square of 2^n × 2^n cells, by its place alone.
///
/// At level l the square has 2^l × 2^l squares, each of a lower triangle (south-west, south-east, north-east)
/// and an upper one (north-east, north-west, south-west): level n is the surface of all samples. Corner 1 has
/// the right angle; corners run counter-clockwise; edge k goes from corner k to corner k + 1. An upper
/// triangle is a lower one turned by 180°, so that a neighbour across edge k has its own edge k there, the
/// other way round.
///
/// Its four children lie between its corners and the middles of its edges: child k at corner k, child 3 in
/// the middle, turned, with corners on the middles of edges 1, 2 and 0.
struct TeRoamTriangle {
  int level = 0;
  std::int32_t x = 0; ///< of its square: 0 .. 2^level - 1
  std::int32_t y = 0;
  bool upper = false;

  /// In units of half a square, from the square's south-west: a corner's place.
  static constexpr int kCornerX[3] = {0, 2, 2};
  static constexpr int kCornerY[3] = {0, 0, 2};

  struct Point {
    std::int32_t column = 0;
    std::int32_t row = 0;
  };
  /// Of a corner, in samples of a map of 2^cellsLog cells a side.
  Point corner(int k, int cellsLog) const {
    const int log = cellsLog - level;
    const int turnedX = upper ? 2 - kCornerX[k] : kCornerX[k],
              turnedY = upper ? 2 - kCornerY[k] : kCornerY[k];
    return {(x << log) + ((turnedX << log) >> 1), (y << log) + ((turnedY << log) >> 1)};
  }
  /// Of the middle of an edge; level is less than cellsLog.
  Point middle(int k, int cellsLog) const {
    const Point a = corner(k, cellsLog), b = corner((k + 1) % 3, cellsLog);
    return {(a.column + b.column) / 2, (a.row + b.row) / 2};
  }

  TeRoamTriangle child(int k) const {
    const bool east = upper ? k == 0 : k != 0;
    const bool north = upper ? k != 2 : k == 2;
    return {level + 1, 2 * x + (east ? 1 : 0), 2 * y + (north ? 1 : 0), k == 3 ? !upper : upper};
  }
  /// Which child of its parent it is; level is more than 0.
  int childNumber() const {
    const int place = (x & 1) | (y & 1) << 1;
    constexpr int kLower[4] = {0, 1, 3, 2}, kUpper[4] = {2, 3, 1, 0};
    return upper ? kUpper[place] : kLower[place];
  }
  TeRoamTriangle parent() const { return {level - 1, x >> 1, y >> 1, (childNumber() == 3) != upper}; }

  /// All triangles above level n are numbered like the nodes of a tree in an array: the two of level 0 are 0
  /// and 1, child k of number i is 4·i + 2 + k. So levels follow each other, and the children of one
  /// triangle.
  static std::uint32_t firstNumber(int level) {
    return std::uint32_t(2 * ((std::uint64_t(1) << 2 * level) - 1) / 3);
  }
  static std::uint32_t childOf(std::uint32_t number, int k) { return 4 * number + 2 + std::uint32_t(k); }
  static std::uint32_t parentOf(std::uint32_t number) { return (number - 2) / 4; }
  /// Cost: a step a level.
  std::uint32_t number() const {
    std::uint32_t place = 0;
    int shift = 0;
    TeRoamTriangle triangle = *this;
    for (; triangle.level > 0; triangle = triangle.parent(), shift += 2)
      place |= std::uint32_t(triangle.childNumber()) << shift;
    return firstNumber(level) + (place | std::uint32_t(triangle.upper ? 1 : 0) << shift);
  }
};
