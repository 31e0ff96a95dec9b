#include "nodes/lod/rtin/TeRtinErrors.h"

#include "nodes/lod/rtin/TeRtinSearch.h"
#include "nodes/lod/rtin/TeRtinTile.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr int kTileCells = 128; ///< larger squares are searched
constexpr int kLeastLegs = 4;   ///< of triangles whose samples a search looks at

/// Gives the middles of sides and diagonals of all squares of a size their errors: at least those of the
/// vertices that depend on them, which have theirs, and `own` of (index, distance to an end of the edge).
/// With tiles, squares of that many cells, only those of squares that touch the rim of one.
template <class Own> void raiseSize(int cells, int size, int tile, float* errors, Own own) {
  const std::ptrdiff_t width = cells + 1;
  const int half = size / 2;
  const std::ptrdiff_t near = half / 2; ///< centres of squares of half the size; 0: there are none
  const auto pair = [errors](std::ptrdiff_t at, std::ptrdiff_t offset) {
    return std::max(errors[at - offset], errors[at + offset]);
  };
  const auto touches = [=](int row) { return row % tile < size || row % tile >= tile - size; };
  // Along a row: all squares, or the outer two of each tile.
  const auto forSquares = [=](bool all, auto each) {
    if (all || tile == size)
      for (int column = 0; column < cells; column += size)
        each(column);
    else
      for (int column = 0; column < cells; column += tile) {
        each(column);
        each(column + tile - size);
      }
  };
  const auto alongRow = [&](int row) {
    forSquares(row % tile == 0, [&](int column) {
      const std::ptrdiff_t at = row * width + column + half;
      float error = own(at, half);
      if (near > 0 && row > 0)
        error = std::max(error, pair(at - near * width, near));
      if (near > 0 && row < cells)
        error = std::max(error, pair(at + near * width, near));
      errors[at] = error;
    });
  };
  const auto acrossRow = [&](int row) {
    const std::ptrdiff_t first = row * width, last = first + cells;
    const int step = touches(row) ? size : tile;
    for (std::ptrdiff_t at = first; at <= last; at += step) {
      float error = own(at, half * width);
      if (near > 0 && at > first)
        error = std::max(error, pair(at - near, near * width));
      if (near > 0 && at < last)
        error = std::max(error, pair(at + near, near * width));
      errors[at] = error;
    }
  };
  const auto centres = [&](int row) {
    const int rowParity = row & size;
    forSquares(touches(row), [&](int column) {
      const std::ptrdiff_t at = row * width + column + half;
      const int toEast = (column & size) == rowParity ? half : -half;
      errors[at] = std::max(own(at, half * width + toEast), std::max(pair(at, half), pair(at, half * width)));
    });
  };
  alongRow(0);
  for (int row = half; row < cells; row += size) {
    alongRow(row + half);
    acrossRow(row);
    centres(row);
  }
}

void createMidpoint(const TeHeightMap& heights, float* errors) {
  const float* samples = heights.data();
  for (int size = 2; size < heights.width(); size *= 2)
    raiseSize(heights.width() - 1, size, size, errors, [samples](std::ptrdiff_t at, std::ptrdiff_t end) {
      return std::fabs(samples[at] - (0.5f * samples[at - end] + 0.5f * samples[at + end]));
    });
}

void createExact(const TeHeightMap& heights, float* errors) {
  const int cells = heights.width() - 1;
  const int tileCells = std::min(kTileCells, cells);
  TeRtinTile(tileCells).raiseAll(heights, errors);
  const auto known = [errors](std::ptrdiff_t at, std::ptrdiff_t) { return errors[at]; };
  // Those at the rims of tiles have dependants in others.
  for (int size = 4; size <= tileCells; size *= 2)
    raiseSize(cells, size, tileCells, errors, known);
  TeRtinSearch search(heights, errors, std::min(kLeastLegs, tileCells));
  for (int size = 2 * tileCells; size <= cells; size *= 2) {
    raiseSize(cells, size, size, errors, known);
    search.raiseSides(size);
    raiseSize(cells, size, size, errors, known);
    search.raiseDiagonals(size);
  }
}

} // namespace

std::vector<float> TeRtinErrors::create(const TeHeightMap& heights, TeRtinError error) {
  std::vector<float> errors(std::size_t(heights.width()) * std::size_t(heights.width()), 0.0f);
  if (error == TeRtinError::Midpoint)
    createMidpoint(heights, errors.data());
  else
    createExact(heights, errors.data());
  return errors;
}
