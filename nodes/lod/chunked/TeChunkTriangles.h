#pragma once

#include "nodes/lod/chunked/TeChunkTree.h"

/// Walks the right triangles of a chunk. A corner is anything that is made from the middle of two others.
///
///     make.at(column, row)            -> Corner, of the chunk's square
///     make.middle(a, b, column, row)  -> Corner, of the sample between
///     take(a, b, apex)                for each triangle, counter-clockwise, a-b its hypotenuse
template <class Corner, class Make, class Take> class TeChunkTriangles {
public:
  /// `everySample`: down to half cells, whatever the level's vertices are.
  TeChunkTriangles(const TeChunkTree& tree, int level, bool everySample, Make& make, Take& take)
      : m_tree(tree), m_level(level), m_everySample(everySample), m_make(make), m_take(take) {}

  void walk(int x, int y) {
    const TeChunkTree::Square square = m_tree.square(m_level, x, y);
    const int east = square.column + square.cells, north = square.row + square.cells;
    const Corner southWest = m_make.at(square.column, square.row), southEast = m_make.at(east, square.row);
    const Corner northWest = m_make.at(square.column, north), northEast = m_make.at(east, north);
    if (square.rising) {
      bisect(northEast, southWest, southEast);
      bisect(southWest, northEast, northWest);
    } else {
      bisect(southEast, northWest, southWest);
      bisect(northWest, southEast, northEast);
    }
  }

private:
  void bisect(const Corner& a, const Corner& b, const Corner& apex) {
    const int column = (a.column + b.column) / 2, row = (a.row + b.row) / 2;
    const bool isCell = (a.column + b.column) % 2 != 0; // half of a cell: there is no sample in the middle
    if (isCell || !(m_everySample || m_tree.isVertex(m_level, column, row))) {
      m_take(a, b, apex);
      return;
    }
    const Corner middle = m_make.middle(a, b, column, row);
    bisect(apex, a, middle);
    bisect(b, apex, middle);
  }

  const TeChunkTree& m_tree;
  int m_level;
  bool m_everySample;
  Make& m_make;
  Take& m_take;
};
