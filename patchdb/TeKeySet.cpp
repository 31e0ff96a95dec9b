#include "patchdb/TeKeySet.h"

#include "generators/base/TeHash.h"

std::size_t TeKeySet::find(const std::vector<Square>& squares, std::int64_t x, std::int64_t y) {
  const std::size_t mask = squares.size() - 1;
  std::size_t at = std::size_t(teHashCombine(std::uint64_t(x), std::uint64_t(y))) & mask;
  while (squares[at].keys && (squares[at].x != x || squares[at].y != y))
    at = (at + 1) & mask;
  return at;
}

bool TeKeySet::contains(std::int64_t x, std::int64_t y) const {
  return !m_squares.empty() && (m_squares[find(m_squares, x >> 3, y >> 3)].keys & bitOf(x, y));
}

bool TeKeySet::insert(std::int64_t x, std::int64_t y) {
  if (4 * (m_used + 1) > 3 * m_squares.size())
    grow();
  Square& square = m_squares[find(m_squares, x >> 3, y >> 3)];
  if (square.keys & bitOf(x, y))
    return false;
  m_used += square.keys ? 0 : 1;
  square.x = x >> 3;
  square.y = y >> 3;
  square.keys |= bitOf(x, y);
  ++m_size;
  return true;
}

void TeKeySet::grow() {
  std::vector<Square> larger(m_squares.empty() ? 4 : 2 * m_squares.size());
  for (const Square& square : m_squares)
    if (square.keys)
      larger[find(larger, square.x, square.y)] = square;
  m_squares.swap(larger);
}
