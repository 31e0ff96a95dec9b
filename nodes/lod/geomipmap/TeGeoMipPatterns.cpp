#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <cassert>

TeGeoMipPatterns::TeGeoMipPatterns(int patchCells) : m_patchCells(patchCells) {
  assert(patchCells >= 2 && patchCells <= kMaxPatchCells && (patchCells & (patchCells - 1)) == 0);
  while (cells(m_levels - 1) > 1)
    m_levels++;
  m_pieces.resize(std::size_t(m_levels));
  for (int level = 0; level < m_levels; level++) {
    Level& pieces = m_pieces[std::size_t(level)];
    const int last = cells(level) - 1;
    if (last == 0) { // no ring: it is the coarsest, so nothing is stitched
      addCell(0, 0, level, pieces.inner);
      for (auto& strips : pieces.strips)
        strips.resize(1);
      continue;
    }
    for (int row = 1; row < last; row++)
      for (int column = 1; column < last; column++)
        addCell(column, row, level, pieces.inner);
    for (int number = 0; number < 4; number++) {
      const auto side = TeGeoMipSide(number);
      auto& strips = pieces.strips[std::size_t(number)];
      strips.resize(std::size_t(m_levels - level));
      for (int i = 1; i < last; i++)
        switch (side) {
        case TeGeoMipSide::South:
          addCell(i, 0, level, strips[0]);
          break;
        case TeGeoMipSide::East:
          addCell(last, i, level, strips[0]);
          break;
        case TeGeoMipSide::North:
          addCell(i, last, level, strips[0]);
          break;
        case TeGeoMipSide::West:
          addCell(0, i, level, strips[0]);
          break;
        }
      for (int border = level + 1; border < m_levels; border++)
        for (const Triangle& triangle : stitched(level, side, border))
          add(triangle, level, strips[std::size_t(border - level)]);
      const bool east = side == TeGeoMipSide::East || side == TeGeoMipSide::North;
      const bool north = side == TeGeoMipSide::North || side == TeGeoMipSide::West;
      addCell(east ? last : 0, north ? last : 0, level, pieces.corners[std::size_t(number)]);
      for (const bool end : {false, true})
        add(half(level, side, end), level, pieces.halves[std::size_t(number)][end]);
    }
  }
}

void TeGeoMipPatterns::add(const Triangle& triangle, int level, Indices& indices) const {
  for (const Point& point : triangle)
    indices.push_back(std::uint16_t((point.y >> level) * (cells(level) + 1) + (point.x >> level)));
}

void TeGeoMipPatterns::addCell(int column, int row, int level, Indices& indices) const {
  const int width = cells(level) + 1;
  const int southWest = row * width + column;
  const int northWest = southWest + width;
  for (const int number : {southWest, southWest + 1, northWest + 1, southWest, northWest + 1, northWest})
    indices.push_back(std::uint16_t(number));
}

TeGeoMipPatterns::Triangle TeGeoMipPatterns::turned(const Triangle& south, TeGeoMipSide side) const {
  Triangle result;
  for (std::size_t i = 0; i < 3; i++) {
    const auto [x, y] = south[i];
    switch (side) {
    case TeGeoMipSide::South:
      result[i] = {x, y};
      break;
    case TeGeoMipSide::East:
      result[i] = {m_patchCells - y, x};
      break;
    case TeGeoMipSide::North:
      result[i] = {m_patchCells - x, m_patchCells - y};
      break;
    case TeGeoMipSide::West:
      result[i] = {y, m_patchCells - x};
      break;
    }
  }
  return result;
}

std::vector<TeGeoMipPatterns::Triangle> TeGeoMipPatterns::regular(int level) const {
  std::vector<Triangle> triangles;
  const int step = 1 << level;
  for (int y = 0; y < m_patchCells; y += step)
    for (int x = 0; x < m_patchCells; x += step) {
      triangles.push_back({Point{x, y}, Point{x + step, y}, Point{x + step, y + step}});
      triangles.push_back({Point{x, y}, Point{x + step, y + step}, Point{x, y + step}});
    }
  return triangles;
}

std::vector<TeGeoMipPatterns::Triangle> TeGeoMipPatterns::stitched(int level, TeGeoMipSide side,
                                                                   int border) const {
  std::vector<Triangle> triangles;
  const int step = 1 << level, wide = 1 << border;
  for (int x = 0; x < m_patchCells; x += wide)
    triangles.push_back(turned({Point{x, 0}, Point{x + wide, 0}, Point{x + wide / 2, step}}, side));
  for (int x = step; x + step < m_patchCells; x += step) {
    const int nearest = (x + wide / 2) / wide * wide; // of the border's vertices
    triangles.push_back(turned({Point{x + step, step}, Point{x, step}, Point{nearest, 0}}, side));
  }
  return triangles;
}

TeGeoMipPatterns::Triangle TeGeoMipPatterns::half(int level, TeGeoMipSide side, bool last) const {
  const int step = 1 << level, far = m_patchCells - step;
  return last ? turned({Point{far, 0}, Point{m_patchCells, 0}, Point{far, step}}, side)
              : turned({Point{0, 0}, Point{step, 0}, Point{step, step}}, side);
}

template <class Add> void TeGeoMipPatterns::forPieces(int level, const TeGeoMipSides& sides, Add add) const {
  const Level& pieces = m_pieces[std::size_t(level)];
  add(pieces.inner);
  for (std::size_t side = 0; side < 4; side++) {
    const std::size_t before = (side + 3) % 4;
    const bool regular = sides[side] == level, regularBefore = sides[before] == level;
    add(pieces.strips[side][std::size_t(sides[side] - level)]);
    if (regular && regularBefore)
      add(pieces.corners[side]);
    else if (regular)
      add(pieces.halves[side][0]);
    else if (regularBefore)
      add(pieces.halves[before][1]);
  }
}

std::int64_t TeGeoMipPatterns::triangles(int level, const TeGeoMipSides& sides) const {
  std::size_t indices = 0;
  forPieces(level, sides, [&](const Indices& piece) { indices += piece.size(); });
  return std::int64_t(indices / 3);
}

void TeGeoMipPatterns::append(int level, const TeGeoMipSides& sides, std::uint32_t first,
                              std::vector<std::uint32_t>& indices) const {
  forPieces(level, sides, [&](const Indices& piece) {
    for (const std::uint16_t number : piece)
      indices.push_back(first + number);
  });
}
