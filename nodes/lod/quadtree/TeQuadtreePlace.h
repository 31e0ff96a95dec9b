#pragma once

#include "nodes/lod/quadtree/TeQuadtreeSquare.h"

#include <vector>

/// A square of the data tree with what its own record lacks: where it is, its corners and its neighbours of
/// the same size.
struct TeQuadtreePlace {
  std::uint32_t square = 0;
  int sideLog = 0;
  std::int32_t x = 0; ///< of its south-west corner
  std::int32_t y = 0;
  std::uint32_t neighbours[4] = {}; ///< 0: there is none
  float corners[4] = {};

  std::int32_t side() const { return std::int32_t(1) << sideLog; }
  std::int32_t half() const { return side() / 2; }
  /// Of the middle of a side.
  std::int32_t columnOf(int s) const { return x + half() * (1 + TeQuadtreeSides::kX[s]); }
  std::int32_t rowOf(int s) const { return y + half() * (1 + TeQuadtreeSides::kY[s]); }

  static std::uint32_t childOf(const std::vector<TeQuadtreeSquare>& squares, std::uint32_t square, int k) {
    const std::uint32_t block = squares[square].block();
    return block != 0 ? 4 * block - 3 + std::uint32_t(k) : 0;
  }
  /// Of a square that has children.
  TeQuadtreePlace child(const std::vector<TeQuadtreeSquare>& squares, int k) const {
    using Sides = TeQuadtreeSides;
    const TeQuadtreeSquare& own = squares[square];
    TeQuadtreePlace child;
    child.square = childOf(squares, square, k);
    child.sideLog = sideLog - 1;
    child.x = x + (Sides::isEast(k) ? half() : 0);
    child.y = y + (Sides::isNorth(k) ? half() : 0);
    for (int s = 0; s < 4; s++) {
      const int across = Sides::mirrored(k, s);
      if (!Sides::touches(k, s))
        child.neighbours[s] = childOf(squares, square, across);
      else if (neighbours[s] != 0)
        child.neighbours[s] = childOf(squares, neighbours[s], across);
    }
    child.corners[k] = corners[k];
    child.corners[Sides::next(k)] = own.edge[Sides::next(k)];
    child.corners[Sides::opposite(k)] = own.centre;
    child.corners[Sides::previous(k)] = own.edge[k];
    return child;
  }
};
