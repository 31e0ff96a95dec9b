#include "generators/base/TeText.h"
#include "nodes/lod/quadtree/TeQuadtreeMesh.h"

using Sides = TeQuadtreeSides;

std::string TeQuadtreeMesh::inconsistency() const {
  std::vector<std::uint32_t> users(m_vertices.size(), 0);
  std::vector<bool> isUsed(m_vertices.size(), false);
  std::size_t squares = 0, vertices = 4;
  for (const std::uint32_t corner : m_squares[0].corners)
    isUsed[corner] = true;
  std::vector<std::uint32_t> stack = {0};
  while (!stack.empty()) {
    const std::uint32_t number = stack.back();
    stack.pop_back();
    squares++;
    const Square& square = m_squares[number];
    const auto wrong = [&](const char* what) {
      return teFormat("square of side 2^%d at (%d, %d): %s", square.sideLog, square.x, square.y, what);
    };
    for (const std::uint32_t corner : square.corners)
      if (!isUsed[corner])
        return wrong("a corner is not enabled");
    for (int i = 0; i <= kCentre; i++) {
      const std::uint32_t vertex = square.vertices[i];
      if (vertex == 0)
        continue;
      vertices += !isUsed[vertex];
      isUsed[vertex] = true;
    }
    if (square.mark != m_frame)
      return wrong("it is left from before");
    for (int s = 0; s < 4; s++) {
      if ((square.vertices[s] != 0) != ((square.edges >> s & 1) != 0))
        return wrong("the middle of an edge is left from before");
      const std::uint32_t neighbour = square.neighbours[s];
      if (neighbour != 0 && m_squares[neighbour].neighbours[Sides::opposite(s)] != number)
        return wrong("a neighbour does not know it");
      if (neighbour != 0 && m_squares[neighbour].vertices[Sides::opposite(s)] != square.vertices[s])
        return wrong("a neighbour has another vertex on the common edge");
      const bool isRim = square.x + Sides::kX[s] * (1 << square.sideLog) < 0 ||
                         square.y + Sides::kY[s] * (1 << square.sideLog) < 0 ||
                         square.x + Sides::kX[s] * (1 << square.sideLog) >= m_tree->side() ||
                         square.y + Sides::kY[s] * (1 << square.sideLog) >= m_tree->side();
      if (square.vertices[s] != 0 && neighbour == 0 && !isRim)
        return wrong("the middle of an edge is enabled on one side only");
    }
    for (int k = 0; k < 4; k++) {
      if (square.children[k] == 0)
        continue;
      if (square.vertices[k] == 0 || square.vertices[Sides::next(k)] == 0)
        return wrong("a child lacks a corner");
      users[square.vertices[k]]++;
      users[square.vertices[Sides::next(k)]]++;
      stack.push_back(square.children[k]);
    }
  }
  for (std::size_t vertex = 1; vertex < users.size(); vertex++)
    if (isUsed[vertex] && users[vertex] != m_vertices[vertex].users)
      return teFormat("vertex (%d, %d): %u squares use it, and it counts %u", m_vertices[vertex].column,
                      m_vertices[vertex].row, users[vertex], m_vertices[vertex].users);
  if (squares + m_freeSquares.size() != m_squares.size())
    return "a square is lost";
  if (1 + vertices + m_freeVertices.size() != m_vertices.size())
    return "a vertex is lost";
  return {};
}
