#pragma once

#include "nodes/lod/order/TeDualGraph.h"

#include <cstdint>
#include <vector>

/// Triangle strips by the heuristic of SGI's tomesh (Akeley, Haeberli and Burns 1990), as document 003 has
/// it: begin at a triangle with the fewest free neighbours, of those at one whose neighbours have the fewest;
/// build three strips along its three edges, extend each backwards, keep the longest; repeat.
class TeTriangleStrips {
public:
  /// Strips that hold every triangle once. `longest`: of a strip, in triangles; 0: any.
  /// Cost: about 0.3 µs a triangle.
  static TeTriangleStrips create(const std::vector<std::uint32_t>& indices, std::int32_t longest = 0);

  /// Triangles of each strip, as numbers among those given, one after the other across edges.
  const std::vector<std::vector<std::int32_t>>& strips() const { return m_strips; }

  /// The triangles, three indices each, in the order of `strips`; each as it was given.
  std::vector<std::uint32_t> triangles(const std::vector<std::uint32_t>& indices) const;

  /// A strip as OpenGL draws it (GL_TRIANGLE_STRIP): every index makes a triangle with the two before it,
  /// every second one turned round. Where a strip does not turn left and right in turn, two vertices are
  /// swapped by repeating one, which makes a triangle of no area.
  static std::vector<std::uint32_t> encode(const std::vector<std::int32_t>& strip,
                                           const std::vector<std::uint32_t>& indices);
  /// All of them as one, joined by triangles of no area.
  std::vector<std::uint32_t> encodeAll(const std::vector<std::uint32_t>& indices) const;
  /// The triangles that a strip draws, three indices each, without those of no area.
  static std::vector<std::uint32_t> decode(const std::vector<std::uint32_t>& strip);

  /// The same strips in the order of best use of a cache of vertices (first in, first out): next is the one
  /// that finds most of its vertices there, as the NVTriStrip library does.
  TeTriangleStrips orderedForCache(const std::vector<std::uint32_t>& indices, std::size_t vertices,
                                   int cacheSize) const;

private:
  std::vector<std::vector<std::int32_t>> m_strips;
};
