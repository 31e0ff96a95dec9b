#include "nodes/seamless/TeSeamlessParts.h"

#include <cassert>
#include <cstdlib>

namespace {

/// Numbers the vertices of the northern tile or the north-east strip; the other orientations have the same.
/// Coordinates count from the patch's centre: u to the east, v to the north, -half .. half.
class TilePattern {
public:
  explicit TilePattern(int resolution) : m_half(resolution / 2) {}

  /// Row 0 is the outermost; row r has 2·(half - r) - 1 vertices.
  int index(int u, int v) const {
    const int row = m_half - v;
    return row * (2 * m_half - row) + u + (m_half - row - 1);
  }
  template <class Give> void forEachVertex(const Give& give) const {
    for (int v = m_half; v > 0; v--)
      for (int u = 1 - v; u < v; u++)
        give(u, v);
  }
  /// Triangles with vertices `step` apart.
  template <class Give> void forEachTriangle(int step, const Give& give) const {
    for (int v = m_half; v > step; v -= step) {
      const int below = v - step;
      const int end = below - step; // of the row below; the row itself ends at `below`
      give(index(-below, v), index(-end, below), index(-end, v));
      for (int u = -end; u < end; u += step) {
        // The cell's diagonal points to the centre of the patch: to the south-east in the west.
        const int a = index(u, below), b = index(u + step, below);
        const int c = index(u + step, v), d = index(u, v);
        if (u < 0) {
          give(a, b, d);
          give(b, c, d);
        } else {
          give(a, b, c);
          give(a, c, d);
        }
      }
      give(index(end, v), index(end, below), index(below, v));
    }
  }

private:
  int m_half;
};

/// Vertices: the diagonal from the centre to the corner; then by falling resolution the flank of the tile
/// before the strip, and likewise those of the tile after it, from the centre outward.
class StripPattern {
public:
  StripPattern(int resolution, int levels) : m_half(resolution / 2), m_levels(levels) {}

  int diagonal(int step, int i) const { return i * step; }
  int flank(bool second, int step, int i) const {
    int start = m_half + 1 + (second ? flankVertices() : 0);
    for (int finer = 1; finer < step; finer *= 2)
      start += m_half / finer;
    return start + i;
  }
  /// give(u, v, whether on the second flank, whether on the diagonal).
  template <class Give> void forEachVertex(const Give& give) const {
    for (int d = 0; d <= m_half; d++)
      give(d, d, false, true);
    for (const bool second : {false, true})
      for (int level = 0, step = 1; level < m_levels; level++, step *= 2)
        for (int d = step; d <= m_half; d += step)
          if (second)
            give(d, d - step, true, false);
          else
            give(d - step, d, false, false);
  }
  /// One half: `flankStep` and the diagonal's step, which is not longer.
  template <class Give>
  void forEachTriangle(bool second, int flankStep, int diagonalStep, const Give& give) const {
    const auto turn = [&](int a, int b, int c) { second ? give(a, c, b) : give(a, b, c); };
    const int fan = flankStep / diagonalStep;
    for (int i = 0; i < m_half / flankStep; i++) {
      const int apex = flank(second, flankStep, i);
      for (int j = i * fan; j < (i + 1) * fan; j++)
        turn(diagonal(diagonalStep, j), diagonal(diagonalStep, j + 1), apex);
      if (i > 0)
        turn(flank(second, flankStep, i - 1), diagonal(diagonalStep, i * fan), apex);
    }
  }

private:
  int flankVertices() const {
    int count = 0;
    for (int level = 0, step = 1; level < m_levels; level++, step *= 2)
      count += m_half / step;
    return count;
  }

  int m_half;
  int m_levels;
};

} // namespace

TeSeamlessParts::TeSeamlessParts(const TeSeamlessLayout& layout, bool wholePatches)
    : m_levels(layout.levels()) {
  const int resolution = layout.maxResolution();
  const int half = resolution / 2;
  const TilePattern tile(resolution);
  const StripPattern strip(resolution, m_levels);

  /// Quarter turns clockwise bring the north to the east.
  const auto addVertex = [&](int turns, int u, int v, int chain) {
    for (; turns > 0; turns--) {
      const int east = v;
      v = -u;
      u = east;
    }
    m_vertices.push_back({std::uint16_t(half + u), std::uint16_t(half + v), std::uint16_t(chain), 0});
  };
  for (int side = 0; side < 4; side++)
    tile.forEachVertex([&](int u, int v) { addVertex(side, u, v, side); });
  m_tileVertices = std::int32_t(m_vertices.size()) / 4;
  for (int side = 0; side < 4; side++)
    strip.forEachVertex([&](int u, int v, bool second, bool diagonal) {
      addVertex(side, u, v, diagonal ? TePartVertex::kDiagonal + side : second ? (side + 1) % 4 : side);
    });
  m_stripVertices = std::int32_t(m_vertices.size()) / 4 - m_tileVertices;

  const auto addTriangle = [&](int a, int b, int c) {
    for (const int index : {a, b, c})
      m_indices.push_back(std::uint16_t(index));
  };
  m_firstIndex.push_back(0);
  for (int step = 1; step < (1 << m_levels); step *= 2) {
    tile.forEachTriangle(step, addTriangle);
    m_firstIndex.push_back(std::int32_t(m_indices.size()));
  }
  for (int first = 1; first < (1 << m_levels); first *= 2)
    for (int second = 1; second < (1 << m_levels); second *= 2) {
      const int diagonal = first < second ? first : second;
      strip.forEachTriangle(false, first, diagonal, addTriangle);
      strip.forEachTriangle(true, second, diagonal, addTriangle);
      m_firstIndex.push_back(std::int32_t(m_indices.size()));
    }
  if (wholePatches && fitsWholePatches(layout))
    addWholePatches(resolution);
}

bool TeSeamlessParts::fitsWholePatches(const TeSeamlessLayout& layout) {
  const std::int64_t resolution = layout.maxResolution();
  if ((resolution + 1) * (resolution + 1) > 65536)
    return false;
  std::int64_t combinations = 1;
  for (int side = 0; side < 4; side++)
    combinations *= layout.levels();
  std::int64_t triangles = 0; // of all resolutions of a whole patch
  for (int index = 0; index < layout.levels(); index++)
    triangles += 2 * std::int64_t(layout.resolutionOf(index)) * layout.resolutionOf(index);
  const std::int64_t bytes =
      combinations * triangles / layout.levels() * 3 * std::int64_t(sizeof(std::uint16_t));
  return bytes <= 8 << 20;
}

void TeSeamlessParts::addWholePatches(int resolution) {
  const int half = resolution / 2;
  m_firstPatchVertex = std::int32_t(m_vertices.size());
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++) {
      const int u = x - half, v = y - half;
      const bool north = v > std::abs(u), south = -v > std::abs(u), east = u > std::abs(v);
      int chain = north ? TeNorth : east ? TeEast : south ? TeSouth : TeWest;
      if (std::abs(u) == std::abs(v))
        chain = TePartVertex::kDiagonal + (u > 0 ? (v > 0 ? TeNorth : TeEast) : (v > 0 ? TeWest : TeSouth));
      m_vertices.push_back({std::uint16_t(x), std::uint16_t(y), std::uint16_t(chain), 0});
    }

  const auto append = [&](const TePart& part) {
    for (int i = part.firstIndex; i < part.firstIndex + part.count; i++) {
      const TePartVertex& vertex = m_vertices[std::size_t(part.firstVertex) + m_indices[std::size_t(i)]];
      m_indices.push_back(std::uint16_t(vertex.y * (resolution + 1) + vertex.x));
    }
  };
  m_firstPatchIndex.push_back(std::int32_t(m_indices.size()));
  std::array<int, 4> indices{};
  for (int combination = 0; combination < m_levels * m_levels * m_levels * m_levels; combination++) {
    for (int side = 3, rest = combination; side >= 0; side--, rest /= m_levels)
      indices[std::size_t(side)] = rest % m_levels;
    for (int side = 0; side < 4; side++) {
      append(tile(side, indices[std::size_t(side)]));
      append(strip(side, indices[std::size_t(side)], indices[std::size_t((side + 1) % 4)]));
    }
    m_firstPatchIndex.push_back(std::int32_t(m_indices.size()));
  }
}

TePart TeSeamlessParts::patch(const std::array<std::uint8_t, 4>& indices) const {
  assert(hasWholePatches());
  std::size_t combination = 0;
  for (const std::uint8_t index : indices)
    combination = combination * std::size_t(m_levels) + index;
  const std::int32_t first = m_firstPatchIndex[combination];
  return {m_firstPatchVertex, first, m_firstPatchIndex[combination + 1] - first};
}

TePart TeSeamlessParts::part(std::int32_t firstVertex, int list) const {
  const std::int32_t first = m_firstIndex[std::size_t(list)];
  return {firstVertex, first, m_firstIndex[std::size_t(list) + 1] - first};
}

TePart TeSeamlessParts::tile(int side, int index) const {
  assert(side >= 0 && side < 4 && index >= 0 && index < m_levels);
  return part(side * m_tileVertices, m_levels - 1 - index);
}

TePart TeSeamlessParts::strip(int side, int a, int b) const {
  assert(side >= 0 && side < 4 && a >= 0 && a < m_levels && b >= 0 && b < m_levels);
  return part(4 * m_tileVertices + side * m_stripVertices,
              m_levels + (m_levels - 1 - a) * m_levels + (m_levels - 1 - b));
}
