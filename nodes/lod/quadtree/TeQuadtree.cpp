#include "nodes/lod/quadtree/TeQuadtree.h"

#include "generators/base/TeText.h"

#include <algorithm>
#include <cmath>

using Sides = TeQuadtreeSides;

namespace {

/// 2^n + 1 samples a side.
int sideLogOf(const TeHeightMap& map) {
  int log = 0;
  while (log < 15 && (1 << log) < map.width() - 1)
    log++;
  return map.width() == map.height() && map.width() - 1 == 1 << log ? log : 0;
}

} // namespace

TeResult<TeQuadtree> TeQuadtree::create(int sideLog, const std::array<float, 4>& corners,
                                        std::shared_ptr<const TeQuadtreeDetail> detail) {
  if (sideLog < 1 || sideLog > kMaxSideLog)
    return TeError{teFormat("a quadtree of a side of 2^%d is not within 2^1 .. 2^%d", sideLog, kMaxSideLog)};
  for (const float height : corners)
    if (!std::isfinite(height))
      return TeError{"a corner of the quadtree has no height"};
  return TeQuadtree(sideLog, corners, std::move(detail));
}

TeResult<TeQuadtree> TeQuadtree::create(const TeHeightMap& map) {
  const int sideLog = sideLogOf(map);
  if (sideLog < 1 || sideLog > 14)
    return TeError{
        teFormat("%d × %d samples are no square of 2^n + 1, n from 1 to 14", map.width(), map.height())};
  if (map.hasMissing())
    return TeError{"a sample of a dense quadtree is missing"};
  const int last = map.width() - 1;
  TeResult<TeQuadtree> tree =
      create(sideLog, {map.at(last, last), map.at(0, last), map.at(0, 0), map.at(last, 0)});
  if (!tree)
    return tree;
  tree->m_squares.reserve(((std::size_t(1) << 2 * sideLog) - 1) / 3);
  const TeStatus inserted = tree->insert(map, 0, 0, 0);
  if (!inserted)
    return inserted.error();
  return tree;
}

TeQuadtree::TeQuadtree(int sideLog, const std::array<float, 4>& corners,
                       std::shared_ptr<const TeQuadtreeDetail> detail)
    : m_sideLog(sideLog), m_corners(corners), m_detail(std::move(detail)) {
  m_squares.resize(1);
  m_squares[0].link = TeQuadtreeSquare::kHasEast | TeQuadtreeSquare::kHasNorth | TeQuadtreeSquare::kHasWest |
                      TeQuadtreeSquare::kHasSouth | TeQuadtreeSquare::kMade;
  for (std::vector<std::uint16_t>& errors : m_rim)
    errors.assign(std::size_t(side()), 0);
  deriveAgain(root(), 0);
  refreshErrors();
}

TeQuadtreePlace TeQuadtree::root() const {
  TeQuadtreePlace root;
  root.sideLog = m_sideLog;
  std::copy(m_corners.begin(), m_corners.end(), root.corners);
  return root;
}

std::optional<TeQuadtreePlace> TeQuadtree::find(int sideLog, std::int32_t x, std::int32_t y) const {
  if (sideLog < 1 || sideLog > m_sideLog || x < 0 || y < 0 || x >= side() || y >= side())
    return {};
  TeQuadtreePlace place = root();
  while (place.sideLog > sideLog) {
    if (m_squares[place.square].block() == 0)
      return {};
    const bool east = x >= place.x + place.half(), north = y >= place.y + place.half();
    place = place.child(m_squares, north ? (east ? 0 : 1) : (east ? 3 : 2));
  }
  return place;
}

std::optional<float> TeQuadtree::height(std::int32_t column, std::int32_t row) const {
  if (column < 0 || row < 0 || column > side() || row > side())
    return {};
  for (int k = 0; k < 4; k++)
    if (column == (Sides::isEast(k) ? side() : 0) && row == (Sides::isNorth(k) ? side() : 0))
      return m_corners[std::size_t(k)];
  const auto powerOf = [](std::int32_t number) { return number == 0 ? 31 : __builtin_ctz(unsigned(number)); };
  const int sideLog = std::min(powerOf(column), powerOf(row)) + 1;
  const std::int32_t half = std::int32_t(1) << (sideLog - 1);
  // On a vertical edge the square lies to the east or west of it, on a horizontal one to the north or south.
  const bool inX = (column & half) != 0, inY = (row & half) != 0;
  const std::int32_t x = inX ? column - half : (column < side() ? column : column - 2 * half);
  const std::int32_t y = inY ? row - half : (row < side() ? row : row - 2 * half);
  const std::optional<TeQuadtreePlace> place = find(sideLog, x, y);
  if (!place)
    return {};
  const TeQuadtreeSquare& square = m_squares[place->square];
  if (inX && inY)
    return square.centre;
  for (int s = 0; s < 4; s++)
    if (place->columnOf(s) == column && place->rowOf(s) == row && square.hasSide(s))
      return square.edge[s];
  return {};
}

std::size_t TeQuadtree::bytes() const {
  std::size_t made = 0;
  for (const std::vector<MadeBlock>& blocks : m_made)
    made += blocks.capacity() * sizeof(MadeBlock);
  return m_squares.capacity() * sizeof(TeQuadtreeSquare) + m_free.capacity() * sizeof(std::uint32_t) + made +
         (m_rim[0].capacity() + m_rim[1].capacity()) * sizeof(std::uint16_t);
}

bool TeQuadtree::isRim(const TeQuadtreePlace& place, int s) const {
  const std::int32_t x = place.x + Sides::kX[s] * place.side(), y = place.y + Sides::kY[s] * place.side();
  return x < 0 || y < 0 || x >= side() || y >= side();
}

float TeQuadtree::derived(float a, float b, std::int32_t column, std::int32_t row, int sideLog) const {
  const double middle = (double(a) + double(b)) / 2;
  return float(m_detail ? middle + double(m_detail->displacement(column, row, sideLog)) : middle);
}

float TeQuadtree::derivedEdge(const TeQuadtreePlace& place, int s) const {
  return derived(place.corners[Sides::previous(s)], place.corners[s], place.columnOf(s), place.rowOf(s),
                 place.sideLog);
}

float TeQuadtree::derivedCentre(const TeQuadtreePlace& place, int quadrant) const {
  return derived(place.corners[quadrant], place.corners[Sides::opposite(quadrant)], place.x + place.half(),
                 place.y + place.half(), place.sideLog);
}

/// Of all that was made before, since what it was derived from may have changed.
void TeQuadtree::deriveAgain(const TeQuadtreePlace& place, int quadrant) {
  TeQuadtreeSquare& square = m_squares[place.square];
  if (square.has(TeQuadtreeSquare::kMade)) {
    square.centre = derivedCentre(place, quadrant);
    for (int s = 0; s < 4; s++) {
      const std::uint32_t neighbour = place.neighbours[s];
      const bool given = neighbour != 0 && !m_squares[neighbour].has(TeQuadtreeSquare::kMade);
      square.edge[s] = given ? m_squares[neighbour].edge[Sides::opposite(s)] : derivedEdge(place, s);
    }
  }
  if (square.block() != 0)
    for (int k = 0; k < 4; k++)
      deriveAgain(place.child(m_squares, k), k);
}

std::uint32_t TeQuadtree::makeSquare(int sideLog, std::int32_t x, std::int32_t y) {
  TeQuadtreePlace place = root();
  while (place.sideLog > sideLog) {
    if (!makeChildren(place))
      return 0;
    const bool east = x >= place.x + place.half(), north = y >= place.y + place.half();
    place = place.child(m_squares, north ? (east ? 0 : 1) : (east ? 3 : 2));
  }
  return place.square;
}

bool TeQuadtree::makeNeighbours(TeQuadtreePlace& place) {
  for (int s = 0; s < 4; s++)
    if (place.neighbours[s] == 0 && !isRim(place, s)) {
      place.neighbours[s] = makeSquare(place.sideLog, place.x + Sides::kX[s] * place.side(),
                                       place.y + Sides::kY[s] * place.side());
      if (place.neighbours[s] == 0)
        return false;
    }
  return true;
}

bool TeQuadtree::makeChildren(TeQuadtreePlace& place) {
  if (m_squares[place.square].block() != 0)
    return true;
  if (!makeNeighbours(place))
    return false;
  std::uint32_t block = 0;
  if (!m_free.empty()) {
    block = m_free.back();
    m_free.pop_back();
  } else {
    block = std::uint32_t((m_squares.size() + 3) / 4);
    if (block > TeQuadtreeSquare::kMaxBlock)
      return false;
    m_squares.resize(m_squares.size() + 4);
  }
  for (int k = 0; k < 4; k++)
    m_squares[4 * block - 3 + std::uint32_t(k)] = TeQuadtreeSquare();
  m_squares[place.square].setBlock(block);
  for (int k = 0; k < 4; k++)
    makeChild(place.child(m_squares, k), k);
  m_made[std::size_t(place.sideLog)].push_back({place.square, place.x, place.y});
  touchAround(place);
  return true;
}

void TeQuadtree::makeChild(const TeQuadtreePlace& child, int quadrant) {
  TeQuadtreeSquare& square = m_squares[child.square];
  square.link = TeQuadtreeSquare::kMade | TeQuadtreeSquare::kDirty;
  square.centre = derivedCentre(child, quadrant);
  for (int s = 0; s < 4; s++) {
    const std::uint32_t neighbour = child.neighbours[s];
    const bool outside = neighbour != 0 && Sides::touches(quadrant, s);
    square.edge[s] = outside ? m_squares[neighbour].edge[Sides::opposite(s)] : derivedEdge(child, s);
    square.set(1u << s, neighbour != 0 || isRim(child, s));
    if (outside)
      m_squares[neighbour].set(1u << Sides::opposite(s) | TeQuadtreeSquare::kDirty, true);
  }
}

/// Errors have to be computed again on the way to a square.
void TeQuadtree::touch(int sideLog, std::int32_t x, std::int32_t y) {
  if (m_refreshesAll)
    return;
  TeQuadtreePlace place = root();
  for (;;) {
    m_squares[place.square].set(TeQuadtreeSquare::kDirty, true);
    if (place.sideLog == sideLog)
      return;
    const bool east = x >= place.x + place.half(), north = y >= place.y + place.half();
    place = place.child(m_squares, north ? (east ? 0 : 1) : (east ? 3 : 2));
  }
}

/// The same for a square whose children were made or dropped: triangles of its neighbours are at its edges.
void TeQuadtree::touchAround(const TeQuadtreePlace& place) {
  touch(place.sideLog, place.x, place.y);
  for (int s = 0; s < 4; s++)
    if (place.neighbours[s] != 0)
      touch(place.sideLog, place.x + Sides::kX[s] * place.side(), place.y + Sides::kY[s] * place.side());
}

TeQuadtree::DetailChange TeQuadtree::detailAround(double column, double row, double reach, int leastSideLog) {
  const Viewer viewer{column, row, reach > 0 ? reach : 0, std::max(1, leastSideLog)};
  DetailChange change;
  change.dropped = dropMade(&viewer);
  const std::int64_t before = squareCount();
  detailIn(root(), viewer);
  change.made = squareCount() - before;
  if (change.made + change.dropped > 0)
    refreshErrors();
  return change;
}

TeQuadtree::DetailChange TeQuadtree::dropDetail() {
  DetailChange change;
  change.dropped = dropMade(nullptr);
  if (change.dropped > 0)
    refreshErrors();
  return change;
}

double TeQuadtree::Viewer::distance(std::int32_t x, std::int32_t y, std::int32_t side) const {
  return std::max({0.0, double(x) - column, column - double(x) - double(side), double(y) - row,
                   row - double(y) - double(side)});
}

void TeQuadtree::detailIn(TeQuadtreePlace place, const Viewer& viewer) {
  const std::int32_t side = place.side();
  if (place.sideLog <= viewer.leastSideLog ||
      !(viewer.distance(place.x, place.y, side) < viewer.reach * double(side)) || !makeChildren(place))
    return;
  for (int k = 0; k < 4; k++)
    detailIn(place.child(m_squares, k), viewer);
}

/// Finer ones first: what is dropped may have been all that needed a coarser one.
std::int64_t TeQuadtree::dropMade(const Viewer* viewer) {
  constexpr double kStay = 1.25;
  std::int64_t dropped = 0;
  for (int sideLog = 1; sideLog <= m_sideLog; sideLog++) {
    std::vector<MadeBlock>& blocks = m_made[std::size_t(sideLog)];
    const std::int32_t side = std::int32_t(1) << sideLog;
    for (std::size_t i = blocks.size(); i-- > 0;) {
      const MadeBlock block = blocks[i];
      if (viewer && sideLog > viewer->leastSideLog &&
          viewer->distance(block.x, block.y, side) < kStay * viewer->reach * double(side))
        continue;
      const TeQuadtreePlace place = *find(sideLog, block.x, block.y);
      if (!mayDrop(place))
        continue;
      dropChildren(place);
      blocks[i] = blocks.back();
      blocks.pop_back();
      dropped += 4;
    }
  }
  return dropped;
}

bool TeQuadtree::mayDrop(const TeQuadtreePlace& place) const {
  const auto isBare = [&](std::uint32_t number) {
    return m_squares[number].block() == 0 && m_squares[number].has(TeQuadtreeSquare::kMade);
  };
  for (int k = 0; k < 4; k++) {
    const TeQuadtreePlace child = place.child(m_squares, k);
    if (!isBare(child.square) || m_squares[child.square].has(TeQuadtreeSquare::kStatic))
      return false;
    for (const int s : {k, Sides::next(k)})
      if (child.neighbours[s] != 0 && !isBare(child.neighbours[s]))
        return false;
  }
  return true;
}

void TeQuadtree::dropChildren(const TeQuadtreePlace& place) {
  touchAround(place);
  for (int k = 0; k < 4; k++) {
    const TeQuadtreePlace child = place.child(m_squares, k);
    for (const int s : {k, Sides::next(k)})
      if (child.neighbours[s] != 0) {
        m_squares[child.neighbours[s]].set(1u << Sides::opposite(s), false);
        m_squares[child.neighbours[s]].set(TeQuadtreeSquare::kDirty, true);
      }
  }
  m_free.push_back(m_squares[place.square].block());
  m_squares[place.square].setBlock(0);
}

void TeQuadtree::setStatic(std::int32_t column, std::int32_t row, std::int32_t width, std::int32_t height,
                           bool isStatic) {
  markStatic(root(), {column, row, width, height}, isStatic);
}

void TeQuadtree::markStatic(const TeQuadtreePlace& place, const TeMapRect& rect, bool isStatic) {
  const std::int64_t side = place.side();
  if (place.x > std::int64_t(rect.x) + rect.width || place.y > std::int64_t(rect.y) + rect.height ||
      place.x + side < rect.x || place.y + side < rect.y)
    return;
  m_squares[place.square].set(TeQuadtreeSquare::kStatic, isStatic);
  if (m_squares[place.square].block() != 0)
    for (int k = 0; k < 4; k++)
      markStatic(place.child(m_squares, k), rect, isStatic);
}
