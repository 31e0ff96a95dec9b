#include "nodes/lod/order/TeObliviousOrder.h"

#include "nodes/lod/order/TeDualGraph.h"

#include <algorithm>
#include <array>

namespace {

constexpr std::int32_t kNone = TeDualGraph::kNone;

/// Halves a range of triangles in place, and its halves.
class Halver {
public:
  explicit Halver(const TeDualGraph& graph)
      : m_graph(graph), m_order(std::size_t(graph.triangles())), m_part(std::size_t(graph.triangles()), 0),
        m_touching(std::size_t(graph.triangles()), 0) {
    for (std::size_t i = 0; i < m_order.size(); i++)
      m_order[i] = std::int32_t(i);
  }

  std::vector<std::int32_t> order() {
    if (!m_order.empty())
      halve(0, m_order.size(), m_order[0]);
    return std::move(m_order);
  }

private:
  /// Orders first .. last - 1, which are those of m_part m_number, beginning near `start`, one of them.
  void halve(std::size_t first, std::size_t last, std::int32_t start) {
    if (last - first <= 2) {
      if (last - first == 2 && m_order[first] != start)
        std::swap(m_order[first], m_order[first + 1]);
      return;
    }
    const std::uint32_t number = ++m_number;
    for (std::size_t i = first; i < last; i++)
      m_part[std::size_t(m_order[i])] = number;
    const std::size_t middle = first + (last - first + 1) / 2;
    grow(first, last, start, number);
    // The second half begins across the cut from what was reached last.
    std::int32_t across = m_order[middle];
    for (std::size_t i = middle; i-- > first;)
      if (const std::int32_t neighbour = neighbourBehind(m_order[i], middle, last); neighbour != kNone) {
        across = neighbour;
        break;
      }
    halve(first, middle, start);
    halve(middle, last, across);
  }

  /// The order in which a part of the mesh grows from `start`: next is the triangle that has most edges with
  /// what is there; of those the one that was reached first.
  void grow(std::size_t first, std::size_t last, std::int32_t start, std::uint32_t number) {
    m_grown.clear();
    for (std::vector<std::int32_t>& queue : m_queues)
      queue.clear();
    std::array<std::size_t, 4> heads{};
    m_queues[0].push_back(start);
    std::size_t unseen = first;
    while (m_grown.size() < last - first) {
      std::int32_t next = kNone;
      for (std::size_t touching = 4; touching-- > 0 && next == kNone;)
        while (heads[touching] < m_queues[touching].size() && next == kNone) {
          const std::int32_t triangle = m_queues[touching][heads[touching]++];
          if (m_part[std::size_t(triangle)] == number && m_touching[std::size_t(triangle)] == touching)
            next = triangle;
        }
      while (next == kNone) { // in pieces
        if (m_part[std::size_t(m_order[unseen])] == number)
          next = m_order[unseen];
        else
          unseen++;
      }
      m_part[std::size_t(next)] = 0;
      m_touching[std::size_t(next)] = 0;
      m_grown.push_back(next);
      for (const std::int32_t neighbour : m_graph.neighbours(next))
        if (neighbour != kNone && m_part[std::size_t(neighbour)] == number)
          m_queues[++m_touching[std::size_t(neighbour)]].push_back(neighbour);
    }
    for (std::size_t i = 0; i < m_grown.size(); i++) {
      m_order[first + i] = m_grown[i];
      m_position.resize(m_order.size());
      m_position[std::size_t(m_grown[i])] = first + i;
    }
  }

  std::int32_t neighbourBehind(std::int32_t triangle, std::size_t from, std::size_t to) const {
    for (const std::int32_t neighbour : m_graph.neighbours(triangle))
      if (neighbour != kNone && m_position[std::size_t(neighbour)] >= from &&
          m_position[std::size_t(neighbour)] < to)
        return neighbour;
    return kNone;
  }

  const TeDualGraph& m_graph;
  std::vector<std::int32_t> m_order;
  std::vector<std::uint32_t> m_part; ///< by triangle: the part that it is in, 0 once it has been reached
  std::vector<std::uint8_t> m_touching;
  std::vector<std::size_t> m_position;
  std::vector<std::int32_t> m_grown;
  std::array<std::vector<std::int32_t>, 4> m_queues;
  std::uint32_t m_number = 0;
};

} // namespace

std::vector<std::int32_t> TeObliviousOrder::create(const std::vector<std::uint32_t>& indices) {
  const TeDualGraph graph(indices);
  return Halver(graph).order();
}
