#include "nodes/lod/TeMeshGaps.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace {

/// Heights of equal walls may be rounded differently.
constexpr double kRounding = 1e-5;

auto keyOf(float fromHeight, float toHeight, std::uint32_t to) {
  return std::make_tuple(to, fromHeight, toHeight);
}

} // namespace

TeMeshGaps::TeMeshGaps(TeLodFieldPtr field)
    : m_field(std::move(field)), m_width(std::uint32_t(m_field->cells()) + 1) {}

std::int64_t TeMeshGaps::count(const TeLodMesh& mesh, const TeLodView& view) {
  sortEdges(mesh);
  m_open.clear();
  std::uint32_t begin = 0;
  for (std::uint32_t from = 0; from < m_width * m_width; from++) {
    const std::uint32_t end = m_ends[from];
    for (std::uint32_t i = begin; i < end;) {
      const Edge& edge = m_edges[i];
      std::uint32_t next = i + 1;
      while (next < end && keyOf(m_edges[next].fromHeight, m_edges[next].toHeight, m_edges[next].to) ==
                               keyOf(edge.fromHeight, edge.toHeight, edge.to))
        next++;
      if (next - i != (onRim(from, edge.to) ? 1u : 2u))
        m_open.push_back({from, edge});
      i = next;
    }
    begin = end;
  }
  const bool skirted = !mesh.skirts.empty();
  if (skirted) {
    gatherWalls(mesh);
    gatherSurfaces();
  }
  std::int64_t gaps = 0;
  for (const Open& open : m_open)
    gaps += inView(open, view) && !(skirted && isHidden(open));
  return gaps;
}

void TeMeshGaps::sortEdges(const TeLodMesh& mesh) {
  const auto sample = [&](const TeLodVertex& vertex) {
    return std::uint32_t(vertex.row) * m_width + std::uint32_t(vertex.column);
  };
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      for (std::size_t side = 0; side < 3; side++) {
        const TeLodVertex& a = mesh.vertices[mesh.indices[i + side]];
        const TeLodVertex& b = mesh.vertices[mesh.indices[i + (side + 1) % 3]];
        if (sample(a) < sample(b))
          visit(sample(a), Edge{sample(b), a.height, b.height});
        else
          visit(sample(b), Edge{sample(a), b.height, a.height});
      }
  };
  // Counting sort by the first sample, then each sample's few.
  m_ends.assign(std::size_t(m_width) * m_width, 0);
  each([&](std::uint32_t from, const Edge&) { m_ends[from]++; });
  std::uint32_t total = 0;
  for (std::uint32_t& end : m_ends)
    total += std::exchange(end, total); // begins for now
  m_edges.resize(total);
  each([&](std::uint32_t from, const Edge& edge) { m_edges[m_ends[from]++] = edge; });
  std::uint32_t begin = 0;
  for (const std::uint32_t end : m_ends) {
    std::sort(m_edges.begin() + begin, m_edges.begin() + end, [](const Edge& a, const Edge& b) {
      return keyOf(a.fromHeight, a.toHeight, a.to) < keyOf(b.fromHeight, b.toHeight, b.to);
    });
    begin = end;
  }
}

bool TeMeshGaps::onRim(std::uint32_t from, std::uint32_t to) const {
  const auto on = [&](std::uint32_t a, std::uint32_t b) { return a == b && (a == 0 || a == m_width - 1); };
  return on(from % m_width, to % m_width) || on(from / m_width, to / m_width);
}

bool TeMeshGaps::inView(const Open& open, const TeLodView& view) const {
  const auto position = [&](std::uint32_t sample, float height) {
    return m_field->position(sample % m_width, sample / m_width, double(height));
  };
  const glm::dvec3 from = position(open.from, open.edge.fromHeight);
  const glm::dvec3 along = position(open.edge.to, open.edge.toHeight) - from;
  double first = 0, last = 1;
  for (int i = 0; i < view.planeCount; i++) {
    const glm::dvec4& plane = view.planes[std::size_t(i)];
    const auto dot = [&](const glm::dvec3& v) { return plane.x * v.x + plane.y * v.y + plane.z * v.z; };
    const double start = dot(from) + plane.w;
    const double slope = dot(along);
    if (slope > 0)
      first = std::max(first, -start / slope);
    else if (slope < 0)
      last = std::min(last, -start / slope);
    else if (start < 0)
      return false;
  }
  return first < last;
}

void TeMeshGaps::gatherWalls(const TeLodMesh& mesh) {
  m_walls.clear();
  for (std::size_t i = 0; i < mesh.skirts.size(); i += 3) {
    std::uint32_t samples[3];
    float heights[3];
    for (std::size_t corner = 0; corner < 3; corner++) {
      const TeLodVertex& vertex = mesh.vertices[mesh.skirts[i + corner]];
      samples[corner] = std::uint32_t(vertex.row) * m_width + std::uint32_t(vertex.column);
      heights[corner] = vertex.height;
    }
    const std::uint32_t from = std::min({samples[0], samples[1], samples[2]});
    const std::uint32_t to = std::max({samples[0], samples[1], samples[2]});
    const auto [found, isNew] = m_walls.try_emplace(std::uint64_t(from) << 32 | to);
    Wall& wall = found->second;
    if (isNew)
      wall.fromLowest = wall.toLowest = std::numeric_limits<float>::infinity();
    float lowest[2] = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    float highest[2] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    for (std::size_t corner = 0; corner < 3; corner++) {
      const int end = samples[corner] == from ? 0 : 1;
      lowest[end] = std::min(lowest[end], heights[corner]);
      highest[end] = std::max(highest[end], heights[corner]);
    }
    for (int end = 0; end < 2; end++)
      wall.area += std::max(0.0, double(highest[end]) - double(lowest[end]));
    wall.fromLowest = std::min(wall.fromLowest, lowest[0]);
    wall.toLowest = std::min(wall.toLowest, lowest[1]);
  }
}

template <class Visit> void TeMeshGaps::alongEdge(const Open& open, const Visit& visit) const {
  const std::int64_t columns = std::int64_t(open.edge.to % m_width) - std::int64_t(open.from % m_width);
  const std::int64_t rows = std::int64_t(open.edge.to / m_width) - std::int64_t(open.from / m_width);
  const std::int64_t steps = std::gcd(columns, rows);
  if (steps == 0)
    return;
  const std::int64_t step = rows / steps * std::int64_t(m_width) + columns / steps;
  for (std::int64_t i = 0; i <= steps; i++)
    visit(std::uint64_t(std::int64_t(open.from) + i * step) << 32 | std::uint64_t(step),
          double(i) / double(steps));
}

void TeMeshGaps::gatherSurfaces() {
  m_beside.clear();
  for (const Open& open : m_open)
    alongEdge(open, [&](std::uint64_t place, double share) {
      const double height = glm::mix(double(open.edge.fromHeight), double(open.edge.toHeight), share);
      const auto [found, isNew] = m_beside.try_emplace(place, Beside{height, 0});
      found->second.lowest = std::min(found->second.lowest, height);
      found->second.edges += share < 1;
    });
}

bool TeMeshGaps::isHidden(const Open& open) const {
  const double from = double(open.edge.fromHeight), to = double(open.edge.toHeight);
  const double tolerance = kRounding * (1 + std::fabs(from) + std::fabs(to));
  double fromBottom = from, toBottom = to;
  if (const auto found = m_walls.find(std::uint64_t(open.from) << 32 | open.edge.to);
      found != m_walls.end()) {
    const Wall& wall = found->second;
    const double whole = from - double(wall.fromLowest) + to - double(wall.toLowest);
    if (wall.area >= whole - tolerance) {
      fromBottom = double(wall.fromLowest);
      toBottom = double(wall.toLowest);
    }
  }
  bool hidden = true;
  alongEdge(open, [&](std::uint64_t place, double share) {
    const Beside& beside = m_beside.at(place);
    const double bottom = glm::mix(fromBottom, toBottom, share) - tolerance;
    const auto sample = std::uint32_t(place >> 32);
    const bool alone = share < 1 && beside.edges < 2;
    hidden = hidden && beside.lowest >= bottom &&
             (!alone || double(m_field->height(int(sample % m_width), int(sample / m_width))) >= bottom);
  });
  return hidden;
}
