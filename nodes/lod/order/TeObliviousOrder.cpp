#include "nodes/lod/order/TeObliviousOrder.h"

#include "nodes/lod/order/TeDualGraph.h"

#include <algorithm>
#include <array>

namespace {

constexpr std::int32_t kNone = TeDualGraph::kNone;

/// Triangles that a part of a mesh may grow by: next is one that has most edges with the part, of those the
/// one that was reached first.
class Front {
public:
  explicit Front(std::size_t triangles) : m_touching(triangles, 0) {}

  void begin(std::int32_t start) {
    for (std::vector<std::int32_t>& queue : m_queues)
      queue.clear();
    m_heads = {};
    m_queues[0].push_back(start);
  }
  /// A neighbour of the part. Forgotten once it is taken by forget().
  void reach(std::int32_t triangle) { m_queues[++m_touching[std::size_t(triangle)]].push_back(triangle); }
  void forget(std::int32_t triangle) { m_touching[std::size_t(triangle)] = 0; }
  /// kNone if no neighbour is left. `isFree`: of a triangle.
  template <class IsFree> std::int32_t next(IsFree isFree) {
    for (std::size_t touching = m_queues.size(); touching-- > 0;)
      while (m_heads[touching] < m_queues[touching].size()) {
        const std::int32_t triangle = m_queues[touching][m_heads[touching]++];
        if (isFree(triangle) && m_touching[std::size_t(triangle)] == touching)
          return triangle;
      }
    return kNone;
  }

private:
  std::vector<std::uint8_t> m_touching; ///< by triangle: edges with the part
  std::array<std::vector<std::int32_t>, 4> m_queues;
  std::array<std::size_t, 4> m_heads{};
};

/// Halves a range of triangles in place, and its halves.
class Halver {
public:
  explicit Halver(const TeDualGraph& graph)
      : m_graph(graph), m_order(std::size_t(graph.triangles())),
        m_part(m_order.size(), 0), m_fronts{Front(m_order.size()), Front(m_order.size())} {
    for (std::size_t i = 0; i < m_order.size(); i++)
      m_order[i] = std::int32_t(i);
  }

  std::vector<std::int32_t> order() {
    if (!m_order.empty())
      halve(0, m_order.size(), m_order[0]);
    return std::move(m_order);
  }

private:
  /// Orders first .. last - 1, beginning near `start`, one of them.
  void halve(std::size_t first, std::size_t last, std::int32_t start) {
    if (last - first <= 2) {
      if (last - first == 2 && m_order[first] != start)
        std::swap(m_order[first], m_order[first + 1]);
      return;
    }
    const std::int32_t end = farthest(first, last, start);
    const std::uint32_t rest = mark(first, last);
    const std::uint32_t halves[2] = {rest + 1, rest + 2};
    m_number += 2;
    m_halves[0].clear();
    m_halves[1].clear();
    m_fronts[0].begin(start);
    m_fronts[1].begin(end);
    const auto isFree = [&](std::int32_t triangle) { return m_part[std::size_t(triangle)] == rest; };
    std::size_t unseen = first;
    for (std::size_t i = first; i < last; i++) {
      // By turns; one that is shut in leaves the rest to the other.
      std::size_t side = m_halves[0].size() <= m_halves[1].size() ? 0 : 1;
      std::int32_t next = m_fronts[side].next(isFree);
      if (next == kNone) {
        side = 1 - side;
        next = m_fronts[side].next(isFree);
      }
      while (next == kNone) { // the mesh is in pieces
        if (isFree(m_order[unseen]))
          next = m_order[unseen];
        else
          unseen++;
      }
      m_part[std::size_t(next)] = halves[side];
      m_fronts[0].forget(next);
      m_fronts[1].forget(next);
      m_halves[side].push_back(next);
      for (const std::int32_t neighbour : m_graph.neighbours(next))
        if (neighbour != kNone && isFree(neighbour))
          m_fronts[side].reach(neighbour);
    }
    const std::size_t middle = first + m_halves[0].size();
    std::copy(m_halves[0].begin(), m_halves[0].end(), m_order.begin() + std::ptrdiff_t(first));
    std::copy(m_halves[1].begin(), m_halves[1].end(), m_order.begin() + std::ptrdiff_t(middle));

    // The second half begins across the cut from what the first reached last.
    std::int32_t across = m_order[middle];
    for (std::size_t i = middle; i-- > first && across == m_order[middle];)
      for (const std::int32_t neighbour : m_graph.neighbours(m_order[i]))
        if (neighbour != kNone && m_part[std::size_t(neighbour)] == halves[1])
          across = neighbour;
    halve(first, middle, start);
    halve(middle, last, across);
  }

  /// Gives a range a number of its own.
  std::uint32_t mark(std::size_t first, std::size_t last) {
    m_number++;
    for (std::size_t i = first; i < last; i++)
      m_part[std::size_t(m_order[i])] = m_number;
    return m_number;
  }

  /// A triangle of a range that takes most steps from `start`, or that cannot be reached.
  std::int32_t farthest(std::size_t first, std::size_t last, std::int32_t start) {
    const std::uint32_t number = mark(first, last);
    m_reached.assign(1, start);
    m_part[std::size_t(start)] = 0;
    for (std::size_t i = 0; i < m_reached.size(); i++)
      for (const std::int32_t neighbour : m_graph.neighbours(m_reached[i]))
        if (neighbour != kNone && m_part[std::size_t(neighbour)] == number) {
          m_part[std::size_t(neighbour)] = 0;
          m_reached.push_back(neighbour);
        }
    if (m_reached.size() < last - first)
      for (std::size_t i = first; i < last; i++)
        if (m_part[std::size_t(m_order[i])] == number)
          return m_order[i];
    return m_reached.back();
  }

  const TeDualGraph& m_graph;
  std::vector<std::int32_t> m_order;
  std::vector<std::uint32_t> m_part; ///< by triangle: the set that it is in
  std::uint32_t m_number = 0;
  std::array<Front, 2> m_fronts;
  std::array<std::vector<std::int32_t>, 2> m_halves;
  std::vector<std::int32_t> m_reached;
};

} // namespace

std::vector<std::int32_t> TeObliviousOrder::create(const std::vector<std::uint32_t>& indices) {
  const TeDualGraph graph(indices);
  return Halver(graph).order();
}
