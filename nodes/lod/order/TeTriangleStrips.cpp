#include "nodes/lod/order/TeTriangleStrips.h"

#include "nodes/lod/order/TeVertexFifo.h"

#include <algorithm>
#include <array>
#include <limits>

namespace {

constexpr std::int32_t kNone = TeDualGraph::kNone;

/// Builds strips, one after the other, from the triangles that are left.
class StripBuilder {
public:
  StripBuilder(const TeDualGraph& graph, std::int32_t longest)
      : m_graph(graph), m_longest(longest > 0 ? longest : std::numeric_limits<std::int32_t>::max()),
        m_used(std::size_t(graph.triangles()), 0), m_degrees(std::size_t(graph.triangles()), 0) {
    for (std::int32_t triangle = 0; triangle < graph.triangles(); triangle++)
      for (const std::int32_t neighbour : graph.neighbours(triangle))
        m_degrees[std::size_t(triangle)] += neighbour != kNone;
    for (std::int32_t triangle = graph.triangles() - 1; triangle >= 0; triangle--)
      enqueue(triangle);
  }

  /// The next strip; empty if no triangle is left.
  std::vector<std::int32_t> next() {
    const std::int32_t start = takeStart();
    if (start == kNone)
      return {};
    std::vector<std::int32_t> best;
    for (int edge = 0; edge < 3; edge++) {
      std::vector<std::int32_t> strip = along(start, edge);
      if (strip.size() > best.size())
        best = std::move(strip);
    }
    for (const std::int32_t triangle : best)
      use(triangle);
    return best;
  }

private:
  /// Fewest free neighbours first, then the fewest of theirs.
  std::size_t rank(std::int32_t triangle) const {
    std::size_t around = 0;
    for (const std::int32_t neighbour : m_graph.neighbours(triangle))
      if (isFree(neighbour))
        around += std::size_t(m_degrees[std::size_t(neighbour)]);
    return std::size_t(m_degrees[std::size_t(triangle)]) * kAround + around;
  }
  void enqueue(std::int32_t triangle) { m_queues[rank(triangle)].push_back(triangle); }

  /// Entries of queues are renewed where ranks change; the old ones are passed over here.
  std::int32_t takeStart() {
    for (std::size_t i = 0; i < m_queues.size(); i++) {
      std::vector<std::int32_t>& queue = m_queues[i];
      while (!queue.empty()) {
        const std::int32_t triangle = queue.back();
        if (m_used[std::size_t(triangle)] == 0 && rank(triangle) == i)
          return triangle;
        queue.pop_back();
      }
    }
    return kNone;
  }

  bool isFree(std::int32_t triangle) const { return triangle != kNone && m_used[std::size_t(triangle)] == 0; }

  /// Forward across an edge of a triangle, then backward from it.
  std::vector<std::int32_t> along(std::int32_t start, int edge) {
    std::vector<std::int32_t> strip{start};
    m_used[std::size_t(start)] = 1;
    if (isFree(m_graph.neighbours(start)[std::size_t(edge)])) {
      extend(strip, m_longest, edge);
      std::vector<std::int32_t> back{start};
      extend(back, m_longest - std::int32_t(strip.size()) + 1, kNone);
      strip.insert(strip.begin(), back.rbegin(), back.rend() - 1);
    }
    for (const std::int32_t triangle : strip)
      m_used[std::size_t(triangle)] = 0;
    return strip;
  }

  /// Appends to a strip of one triangle, up to `longest`; first across a given edge, or kNone.
  void extend(std::vector<std::int32_t>& strip, std::int32_t longest, int firstEdge) {
    int turn = 0, entry = 0;
    while (std::int32_t(strip.size()) < longest) {
      const std::int32_t last = strip.back();
      const int edge = strip.size() == 1 && firstEdge != kNone ? firstEdge : bestEdge(last, entry, turn);
      if (edge == kNone)
        return;
      turn = (edge - entry + 3) % 3;
      const std::int32_t next = m_graph.neighbours(last)[std::size_t(edge)];
      m_used[std::size_t(next)] = 1;
      strip.push_back(next);
      const auto& around = m_graph.neighbours(next);
      entry = int(std::find(around.begin(), around.end(), last) - around.begin());
    }
  }

  /// To the neighbour with the fewest free neighbours; of two to that for which the strip, which came in by
  /// the edge `entry` after a turn, turns left and right by turns: then it takes no swap.
  int bestEdge(std::int32_t triangle, int entry, int turn) const {
    const auto& neighbours = m_graph.neighbours(triangle);
    int best = kNone;
    for (int edge = 0; edge < 3; edge++) {
      if (!isFree(neighbours[std::size_t(edge)]))
        continue;
      const int more =
          best == kNone ? -1
                        : degreeOf(neighbours[std::size_t(edge)]) - degreeOf(neighbours[std::size_t(best)]);
      if (more < 0 || (more == 0 && (edge - entry + 3) % 3 != turn))
        best = edge;
    }
    return best;
  }

  int degreeOf(std::int32_t triangle) const { return m_degrees[std::size_t(triangle)]; }

  void use(std::int32_t triangle) {
    m_used[std::size_t(triangle)] = 1;
    for (const std::int32_t neighbour : m_graph.neighbours(triangle))
      if (isFree(neighbour)) {
        m_degrees[std::size_t(neighbour)]--;
        enqueue(neighbour);
        for (const std::int32_t second : m_graph.neighbours(neighbour))
          if (isFree(second))
            enqueue(second);
      }
  }

  static constexpr std::size_t kAround = 10; ///< three neighbours of three each

  const TeDualGraph& m_graph;
  std::int32_t m_longest;
  std::vector<std::uint8_t> m_used;
  std::vector<std::int8_t> m_degrees; ///< free neighbours of free triangles
  std::array<std::vector<std::int32_t>, 4 * kAround> m_queues;
};

using Corners = std::array<std::uint32_t, 3>;

Corners cornersOf(std::int32_t triangle, const std::vector<std::uint32_t>& indices) {
  const std::size_t first = 3 * std::size_t(triangle);
  return {indices[first], indices[first + 1], indices[first + 2]};
}

bool contains(const Corners& corners, std::uint32_t vertex) {
  return std::find(corners.begin(), corners.end(), vertex) != corners.end();
}

/// The corner that another triangle lacks.
std::uint32_t cornerBeside(const Corners& corners, const Corners& other) {
  return *std::find_if(corners.begin(), corners.end(),
                       [&](std::uint32_t vertex) { return !contains(other, vertex); });
}

} // namespace

TeTriangleStrips TeTriangleStrips::create(const std::vector<std::uint32_t>& indices, std::int32_t longest) {
  const TeDualGraph graph(indices);
  StripBuilder builder(graph, longest);
  TeTriangleStrips strips;
  for (std::vector<std::int32_t> strip = builder.next(); !strip.empty(); strip = builder.next())
    strips.m_strips.push_back(std::move(strip));
  return strips;
}

std::vector<std::uint32_t> TeTriangleStrips::triangles(const std::vector<std::uint32_t>& indices) const {
  std::vector<std::uint32_t> ordered;
  ordered.reserve(indices.size());
  for (const std::vector<std::int32_t>& strip : m_strips)
    for (const std::int32_t triangle : strip)
      for (const std::uint32_t corner : cornersOf(triangle, indices))
        ordered.push_back(corner);
  return ordered;
}

std::vector<std::uint32_t> TeTriangleStrips::encode(const std::vector<std::int32_t>& strip,
                                                    const std::vector<std::uint32_t>& indices) {
  if (strip.empty())
    return {};
  Corners last = cornersOf(strip[0], indices);
  if (strip.size() > 1) // the edge to the next triangle last
    while (contains(cornersOf(strip[1], indices), last[0]))
      std::rotate(last.begin(), last.begin() + 1, last.end());
  std::vector<std::uint32_t> encoded(last.begin(), last.end());
  for (std::size_t i = 1; i < strip.size(); i++) {
    const Corners next = cornersOf(strip[i], indices);
    const std::size_t count = encoded.size();
    const std::uint32_t first = encoded[count - 3], newest = encoded[count - 1];
    if (contains(next, first)) { // not across the edge that comes by turns: a swap
      encoded.back() = first;
      encoded.push_back(newest);
    }
    encoded.push_back(cornerBeside(next, cornersOf(strip[i - 1], indices)));
  }
  return encoded;
}

std::vector<std::uint32_t> TeTriangleStrips::encodeAll(const std::vector<std::uint32_t>& indices) const {
  std::vector<std::uint32_t> joined;
  for (const std::vector<std::int32_t>& strip : m_strips) {
    const std::vector<std::uint32_t> encoded = encode(strip, indices);
    if (!joined.empty()) {
      joined.push_back(joined.back());
      joined.push_back(encoded.front());
      if (joined.size() % 2 != 0) // a strip's first triangle is not turned round
        joined.push_back(encoded.front());
    }
    joined.insert(joined.end(), encoded.begin(), encoded.end());
  }
  return joined;
}

std::vector<std::uint32_t> TeTriangleStrips::decode(const std::vector<std::uint32_t>& strip) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < strip.size(); i++) {
    const std::uint32_t a = strip[i], b = strip[i + 1], c = strip[i + 2];
    if (a == b || b == c || c == a)
      continue;
    if (i % 2 == 0)
      triangles.insert(triangles.end(), {a, b, c});
    else
      triangles.insert(triangles.end(), {b, a, c});
  }
  return triangles;
}

TeTriangleStrips TeTriangleStrips::orderedForCache(const std::vector<std::uint32_t>& indices,
                                                   std::size_t vertices, int cacheSize) const {
  // Strips at each vertex, one list after the other.
  std::vector<std::uint32_t> firstAt(vertices + 1, 0);
  const auto forCorners = [&](auto each) {
    for (std::size_t strip = 0; strip < m_strips.size(); strip++)
      for (const std::int32_t triangle : m_strips[strip])
        for (const std::uint32_t corner : cornersOf(triangle, indices))
          each(corner, std::uint32_t(strip));
  };
  forCorners([&](std::uint32_t corner, std::uint32_t) { firstAt[corner + 1]++; });
  for (std::size_t vertex = 0; vertex < vertices; vertex++)
    firstAt[vertex + 1] += firstAt[vertex];
  std::vector<std::uint32_t> stripsAt(indices.size());
  std::vector<std::uint32_t> filled(firstAt.begin(), firstAt.end() - 1);
  forCorners([&](std::uint32_t corner, std::uint32_t strip) { stripsAt[filled[corner]++] = strip; });

  TeTriangleStrips ordered;
  TeVertexFifo cache(vertices, cacheSize);
  std::vector<std::uint8_t> isDone(m_strips.size(), 0);
  std::vector<std::uint32_t> hits(m_strips.size(), 0), candidates, recent;
  std::size_t unseen = 0;
  while (ordered.m_strips.size() < m_strips.size()) {
    candidates.clear();
    for (const std::uint32_t vertex : recent)
      if (cache.contains(vertex))
        for (std::uint32_t at = firstAt[vertex]; at < firstAt[vertex + 1]; at++)
          if (const std::uint32_t strip = stripsAt[at]; isDone[strip] == 0 && hits[strip]++ == 0)
            candidates.push_back(strip);
    std::size_t best = m_strips.size();
    double bestShare = 0;
    for (const std::uint32_t strip : candidates) {
      const double share = double(hits[strip]) / double(m_strips[strip].size());
      if (share > bestShare) {
        bestShare = share;
        best = strip;
      }
      hits[strip] = 0;
    }
    if (best == m_strips.size()) {
      while (isDone[unseen] != 0)
        unseen++;
      best = unseen;
    }
    isDone[best] = 1;
    for (const std::int32_t triangle : m_strips[best])
      for (const std::uint32_t corner : cornersOf(triangle, indices))
        if (!cache.use(corner))
          recent.push_back(corner);
    if (recent.size() > std::size_t(cacheSize))
      recent.erase(recent.begin(), recent.end() - cacheSize);
    ordered.m_strips.push_back(m_strips[best]);
  }
  return ordered;
}
