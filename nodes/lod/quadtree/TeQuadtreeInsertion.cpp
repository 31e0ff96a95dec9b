#include "nodes/lod/quadtree/TeQuadtree.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

using Sides = TeQuadtreeSides;

/// A map and where it lies in the lattice.
struct TeQuadtree::Insertion {
  const TeHeightMap& map;
  std::int64_t column, row;
  int level;
  bool isStatic;

  /// Missing where the map has no sample.
  float at(std::int64_t x, std::int64_t y) const {
    const std::int64_t i = x - column, j = y - row;
    const std::int64_t mask = (std::int64_t(1) << level) - 1;
    if (i < 0 || j < 0 || ((i | j) & mask) != 0)
      return TeHeightMap::missing();
    const std::int64_t across = i >> level, up = j >> level;
    return across < map.width() && up < map.height() ? map.at(int(across), int(up)) : TeHeightMap::missing();
  }
  bool overlaps(const TeQuadtreePlace& place) const {
    const std::int64_t right = column + (std::int64_t(map.width() - 1) << level);
    const std::int64_t top = row + (std::int64_t(map.height() - 1) << level);
    return place.x < right && place.y < top && place.x + place.side() > column &&
           place.y + place.side() > row;
  }
};

TeStatus TeQuadtree::insert(const TeHeightMap& map, std::int32_t column, std::int32_t row, int level,
                            bool isStatic) {
  if (level < 0 || level >= m_sideLog)
    return TeError{teFormat("samples 2^%d apart do not fit a quadtree of a side of 2^%d", level, m_sideLog)};
  const std::int32_t mask = (std::int32_t(1) << level) - 1;
  if (((column | row) & mask) != 0)
    return TeError{teFormat("a map of samples 2^%d apart cannot lie at (%d, %d)", level, column, row)};
  for (int y = 0; y < map.height(); y++)
    for (int x = 0; x < map.width(); x++)
      if (std::isinf(map.at(x, y)))
        return TeError{teFormat("the height of sample (%d, %d) is infinite", x, y)};
  m_heightsVersion++;
  m_refreshesAll = true;
  const Insertion insertion{map, column, row, level, isStatic};
  bool fits = true;
  for (int sideLog = m_sideLog; fits && sideLog > level; sideLog--)
    fits = insertLevel(root(), sideLog, insertion);
  deriveAgain(root(), 0);
  forgetGiven();
  m_squares.shrink_to_fit();
  refreshErrors();
  if (!fits)
    return TeError{teFormat("a quadtree has no more than %u squares", 4 * TeQuadtreeSquare::kMaxBlock + 1)};
  return TeStatus();
}

/// Blocks with data are not dropped.
void TeQuadtree::forgetGiven() {
  for (std::vector<MadeBlock>& blocks : m_made) {
    const auto isGiven = [&](const MadeBlock& block) {
      for (int k = 0; k < 4; k++)
        if (!m_squares[child(block.parent, k)].has(TeQuadtreeSquare::kMade))
          return true;
      return false;
    };
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isGiven), blocks.end());
    blocks.shrink_to_fit();
  }
}

/// All squares of one size, so that their neighbours are there before their children are.
bool TeQuadtree::insertLevel(TeQuadtreePlace place, int sideLog, const Insertion& insertion) {
  if (!insertion.overlaps(place))
    return true;
  if (place.sideLog == sideLog)
    return insertHeights(place, insertion);
  for (int k = 0; k < 4; k++)
    if (!insertLevel(place.child(m_squares, k), sideLog, insertion))
      return false;
  return true;
}

bool TeQuadtree::insertHeights(TeQuadtreePlace& place, const Insertion& insertion) {
  if (!makeNeighbours(place))
    return false;
  bool isGiven = false;
  const float centre = insertion.at(place.x + place.half(), place.y + place.half());
  if (!TeHeightMap::isMissing(centre)) {
    m_squares[place.square].centre = centre;
    isGiven = true;
  }
  for (int s = 0; s < 4; s++) {
    const float middle = insertion.at(place.columnOf(s), place.rowOf(s));
    if (TeHeightMap::isMissing(middle))
      continue;
    m_squares[place.square].edge[s] = middle;
    if (place.neighbours[s] != 0)
      m_squares[place.neighbours[s]].edge[Sides::opposite(s)] = middle;
    isGiven = true;
  }
  if (isGiven)
    m_squares[place.square].set(TeQuadtreeSquare::kMade, false);
  if (insertion.isStatic)
    m_squares[place.square].set(TeQuadtreeSquare::kStatic, true);
  return place.sideLog <= insertion.level + 1 || makeChildren(place);
}
