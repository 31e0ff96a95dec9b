#include "nodes/terrain/TeGridLevels.h"

#include <algorithm>

TeGridLevels::TeGridLevels(int columns, int rows) : m_columns(columns), m_rows(rows) {
  const int narrow = std::min(columns, rows), wide = std::max(columns, rows);
  if (narrow < 3 || wide < 4)
    return;
  if (narrow == 3) {
    addStrip();
    return;
  }
  for (int step = 2;; step *= 2) {
    addLevel(step);
    const Lines x = linesOf(columns, step), y = linesOf(rows, step);
    if (x.first == x.last && y.first == y.last)
      return;
  }
}

std::size_t TeGridLevels::bytes() const {
  std::size_t bytes = 0;
  for (const std::vector<std::uint32_t>& level : m_levels)
    bytes += level.size() * sizeof(std::uint32_t);
  return bytes;
}

TeGridLevels::Lines TeGridLevels::linesOf(int vertices, int step) {
  const int cells = vertices - 1;
  const int length = std::max(0, cells / step - 1) * step;
  const int first = (cells - length) / 2;
  return {first, first + length};
}

void TeGridLevels::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  m_levels.back().insert(m_levels.back().end(), {a, b, c});
}

void TeGridLevels::addLevel(int step) {
  m_levels.emplace_back();
  const Lines x = linesOf(m_columns, step), y = linesOf(m_rows, step);
  for (int row = y.first; row < y.last; row += step)
    for (int column = x.first; column < x.last; column += step) {
      const std::uint32_t southWest = vertex(column, row), northEast = vertex(column + step, row + step);
      addTriangle(southWest, vertex(column + step, row), northEast);
      addTriangle(southWest, northEast, vertex(column, row + step));
    }
  addRing(x, y, step);
}

/// Between the rim and the inner rectangle: on each side, two rows of vertices that are joined by going on
/// along the one that lies behind. Counter-clockwise around, the rim to the right.
void TeGridLevels::addRing(Lines columns, Lines rows, int step) {
  struct Corner {
    int column;
    int row;
  };
  const Corner outer[] = {{0, 0}, {m_columns - 1, 0}, {m_columns - 1, m_rows - 1}, {0, m_rows - 1}};
  const Corner inner[] = {{columns.first, rows.first},
                          {columns.last, rows.first},
                          {columns.last, rows.last},
                          {columns.first, rows.last}};
  for (int side = 0; side < 4; ++side) {
    const Corner from = outer[side], in = inner[side], inEnd = inner[(side + 1) % 4];
    const int alongColumns = side == 0 ? 1 : side == 2 ? -1 : 0;
    const int alongRows = side == 1 ? 1 : side == 3 ? -1 : 0;
    const auto at = [&](const Corner& start, int way) {
      return vertex(start.column + alongColumns * way, start.row + alongRows * way);
    };
    const auto along = [&](const Corner& corner) {
      return (corner.column - from.column) * alongColumns + (corner.row - from.row) * alongRows;
    };
    const int outerEnd = (alongColumns != 0 ? m_columns : m_rows) - 1;
    const int offset = along(in), innerEnd = along(inEnd) - offset;
    int out = 0, on = 0;
    while (out < outerEnd || on < innerEnd) {
      const bool goesOut = on == innerEnd || (out < outerEnd && 2 * out + 1 <= 2 * (offset + on) + step);
      if (goesOut) {
        addTriangle(at(from, out), at(from, out + 1), at(in, on));
        ++out;
      } else {
        addTriangle(at(from, out), at(in, on + step), at(in, on));
        on += step;
      }
    }
  }
}

void TeGridLevels::addStrip() {
  m_levels.emplace_back();
  const bool isLying = m_rows == 3;
  // `along` the strip, `across` it; a lying strip is a standing one mirrored at its diagonal.
  const auto at = [&](int across, int along) {
    return isLying ? vertex(along, across) : vertex(across, along);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    isLying ? addTriangle(a, c, b) : addTriangle(a, b, c);
  };
  const int last = std::max(m_columns, m_rows) - 1;
  // The ends keep their middle vertices.
  add(at(0, 0), at(1, 0), at(0, 1));
  add(at(1, 0), at(2, 1), at(0, 1));
  add(at(1, 0), at(2, 0), at(2, 1));
  for (int i = 1; i + 1 < last; ++i) {
    add(at(0, i), at(2, i), at(2, i + 1));
    add(at(0, i), at(2, i + 1), at(0, i + 1));
  }
  add(at(0, last - 1), at(1, last), at(0, last));
  add(at(0, last - 1), at(2, last - 1), at(1, last));
  add(at(2, last - 1), at(2, last), at(1, last));
}
