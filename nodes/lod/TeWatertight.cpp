#include "nodes/lod/TeWatertight.h"

#include <algorithm>

void TeWatertight::clear() {
  m_edges.clear();
  m_doubleArea = 0;
  m_slivers = 0;
}

void TeWatertight::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t width = std::uint32_t(m_resolution) + 1;
  const auto column = [&](std::uint32_t vertex) { return std::int64_t(vertex % width); };
  const auto row = [&](std::uint32_t vertex) { return std::int64_t(vertex / width); };
  const std::int64_t area =
      (column(b) - column(a)) * (row(c) - row(a)) - (column(c) - column(a)) * (row(b) - row(a));
  m_doubleArea += area;
  m_slivers += area <= 0;
  const auto addEdge = [&](std::uint32_t from, std::uint32_t to) {
    m_edges.push_back(std::uint64_t(std::min(from, to)) << 32 | std::max(from, to));
  };
  addEdge(a, b);
  addEdge(b, c);
  addEdge(c, a);
}

std::int64_t TeWatertight::cracks() {
  std::sort(m_edges.begin(), m_edges.end());
  std::int64_t cracks = 0;
  for (std::size_t i = 0; i < m_edges.size();) {
    const std::uint64_t edge = m_edges[i];
    std::size_t end = i + 1;
    while (end < m_edges.size() && m_edges[end] == edge)
      end++;
    const std::size_t wanted = onRim(std::uint32_t(edge >> 32), std::uint32_t(edge)) ? 1 : 2;
    cracks += end - i != wanted;
    i = end;
  }
  return cracks;
}

bool TeWatertight::onRim(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t last = std::uint32_t(m_resolution), width = last + 1;
  return (a / width == 0 && b / width == 0) || (a / width == last && b / width == last) ||
         (a % width == 0 && b % width == 0) || (a % width == last && b % width == last);
}
