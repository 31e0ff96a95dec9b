#pragma once

#include <array>
#include <cstdint>

/// How a triangle of the triangle quadtree is drawn when some of its neighbours are split, so that the
/// middles of its edges to them are vertices: without a crack, and without splitting it.
///
/// Points 0, 1, 2 are its corners, 3 + k is the middle of edge k. With one edge point there are two
/// triangles, with two three, with three the four children.
struct TeRoamFan {
  using Triangle = std::array<std::uint8_t, 3>; ///< of points, counter-clockwise

  int count = 0;
  std::array<Triangle, 4> triangles{};

  /// By a mask of edge points: bit k for edge k.
  static const std::array<TeRoamFan, 8>& all() {
    static constexpr std::array<TeRoamFan, 8> fans = {{
        {1, {{{0, 1, 2}}}},
        {2, {{{0, 3, 2}, {3, 1, 2}}}},
        {2, {{{1, 4, 0}, {4, 2, 0}}}},
        {3, {{{3, 1, 4}, {0, 3, 2}, {3, 4, 2}}}},
        {2, {{{2, 5, 1}, {5, 0, 1}}}},
        {3, {{{5, 0, 3}, {2, 5, 1}, {5, 3, 1}}}}, // the shorter diagonal of what is left
        {3, {{{4, 2, 5}, {1, 4, 5}, {1, 5, 0}}}},
        {4, {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {4, 5, 3}}}},
    }};
    return fans;
  }
};
