#include "nodes/lod/order/TeDualGraph.h"

#include <algorithm>

TeDualGraph::TeDualGraph(const std::vector<std::uint32_t>& indices)
    : m_neighbours(indices.size() / 3, {kNone, kNone, kNone}) {
  struct Edge {
    std::uint64_t ends;
    std::int32_t triangle;
    std::int32_t number;
  };
  std::vector<Edge> edges;
  edges.reserve(indices.size());
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    for (std::size_t edge = 0; edge < 3; edge++) {
      const std::uint32_t from = indices[i + edge], to = indices[i + (edge + 1) % 3];
      edges.push_back({std::uint64_t(std::min(from, to)) << 32 | std::max(from, to), std::int32_t(i / 3),
                       std::int32_t(edge)});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
  });
  const auto cornerSum = [&](std::int32_t triangle) {
    const std::size_t first = 3 * std::size_t(triangle);
    return std::uint64_t(indices[first]) + indices[first + 1] + indices[first + 2];
  };
  for (std::size_t i = 0; i + 1 < edges.size(); i++)
    if (edges[i].ends == edges[i + 1].ends && edges[i].triangle != edges[i + 1].triangle &&
        cornerSum(edges[i].triangle) != cornerSum(edges[i + 1].triangle)) { // else the same corners
      const Edge &a = edges[i], &b = edges[i + 1];
      m_neighbours[std::size_t(a.triangle)][std::size_t(a.number)] = b.triangle;
      m_neighbours[std::size_t(b.triangle)][std::size_t(b.number)] = a.triangle;
      i++;
    }
}
